#include "tests/peers/PeerRuns.h"

#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "io/base/AtomicFile.h"

namespace fenestra::peers {

int runProgram(int argc, char** argv, const std::string& description,
               const std::function<void(const Options&)>& measure) {
  Options options;
  CLI::App program{description};
  program.add_option("FOLDER", options.folder, "the report's folder")->required();
  bench::addViewOptions(program, options.views);
  CLI11_PARSE(program, argc, argv);
  try {
    std::filesystem::create_directories(options.folder / "peers");
    measure(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << program.get_name() << ": " << error.what() << '\n';
    return 1;
  }
}

void writePicture(const Options& options, const std::string& file, const std::vector<float>& colours) {
  io::writeLayer(options.folder / "peers" / file, {static_cast<int>(colours.size() / 4), 1}, 4, colours);
}

void writeRuns(const Options& options, const Program& program, const nlohmann::ordered_json& runs) {
  const bench::Views& views = options.views;
  const std::string part = views.only.empty() ? "" : "-" + views.only;
  io::writeText(options.folder / "peers" / (program.name + part + ".json"),
                nlohmann::ordered_json{{"program", program.title},
                                       {"version", program.version},
                                       {"machine", program.machine},
                                       {"size", {views.size.x, views.size.y}},
                                       {"cameras", views.cameras},
                                       {"compared", views.compared},
                                       {"pixelBlock", views.pixelBlock},
                                       {"phantomVoxels", views.phantomVoxels},
                                       {"parallel", views.parallel},
                                       {"runs", runs}}
                        .dump(1) +
                    "\n");
}

}  // namespace fenestra::peers
