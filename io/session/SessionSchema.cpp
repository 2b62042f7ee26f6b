#include "io/session/SessionSchema.h"

#include "io/session/SessionFile.h"
#include "io/session/SessionJson.h"

namespace fenestra::io {

std::string sessionSchema() {
  json::Value schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Fenestra session"},
      {"description",
       "What a user did to a study, and where the study is. Members that a version does not know are kept and written "
       "back. Lengths are mm and coordinates are the patient's (LPS) unless said otherwise; colours are display RGB, "
       "0..1."},
  };
  json::Value members = json::schemaOf(Session());
  json::Value properties{
      {"format", {{"const", sessionFormat}}},
      {"version",
       {{"const", sessionVersion}, {"description", "Raised only when an older program would misread the file"}}}};
  properties.update(members["properties"]);
  members["properties"] = std::move(properties);
  members["required"].insert(members["required"].begin(), {"format", "version"});
  schema.update(members);
  schema["oneOf"] = {{{"required", {"volume"}}}, {{"required", {"phantom"}}}};
  schema["$defs"] = {
      {"path",
       {{"type", "string"},
        {"description",
         "Relative to the folder of this file, never absolute, in UTF-8 with slashes. May begin with \"..\"."}}}};
  return json::textOf(schema);
}

}  // namespace fenestra::io
