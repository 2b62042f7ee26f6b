#include "rendering/gl/ShaderProgram.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>

#include <epoxy/gl.h>

#include "fenestra/shaders.h"

namespace fenestra::gl {
namespace {

/// What a uniform is called where it is stored.
std::string storedName(std::string_view uniform) { return std::string(uniform) + "Stored[1]"; }
std::string elementName(std::string_view uniform) { return std::string(uniform) + "Stored[0]"; }

/// "uniform vec2 a, b;" as stored arrays of one and variables with their values at the start of main(); any other line
/// as it is. llvmpipe reads a uniform that is named in a loop or a branch lane by lane, at each pass of the loop, and
/// compilers put a copy of a uniform back to where it is used, unless it is one of an array's element.
std::string withUniformsReadOnce(const std::string& line) {
  constexpr std::array plain{"float", "int", "bool", "vec2", "vec3", "vec4", "ivec2", "ivec3", "ivec4", "mat3", "mat4"};
  std::istringstream words(line);
  std::string keyword, type, name, stored, copies;
  words >> keyword >> type;
  const std::size_t end = line.find(';');
  if (keyword != "uniform" || end == std::string::npos || std::ranges::find(plain, type) == plain.end()) return line;
  const std::size_t begin = line.find(type) + type.size();
  for (std::istringstream names(line.substr(begin, end - begin)); std::getline(names >> std::ws, name, ',');) {
    stored += (stored.empty() ? "" : ", ") + storedName(name);
    copies += (copies.empty() ? "" : ", ") + name + " = " + elementName(name);
  }
  return "uniform " + type + ' ' + stored + "; " + type + ' ' + copies + line.substr(end);
}

/// Appends the file with its includes; line directives carry an index into `files`, which errors are translated with.
void expand(std::string_view path, std::vector<std::string>& files, std::ostringstream& out) {
  if (std::find(files.begin(), files.end(), path) != files.end()) return;
  const std::string_view source = shaders::find(path);
  if (source.empty()) throw ShaderError("no embedded shader '" + std::string(path) + "'");
  const std::size_t file = files.size();
  files.emplace_back(path);
  out << "#line 1 " << file << '\n';
  std::istringstream lines{std::string(source)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    constexpr std::string_view include = "#include \"";
    if (line.starts_with(include)) {
      expand(line.substr(include.size(), line.rfind('"') - include.size()), files, out);
      out << "#line " << number + 1 << ' ' << file << '\n';
    } else {
      out << withUniformsReadOnce(line) << '\n';
    }
  }
}

std::string sourceOf(std::string_view path, const std::vector<Define>& defines, std::vector<std::string>& files) {
  std::ostringstream out;
  out << "#version 450 core\n";
  for (const Define& define : defines) out << "#define " << define.name << ' ' << define.value << '\n';
  expand(path, files, out);
  return out.str();
}

GLuint compile(GLenum stage, std::string_view path, const std::vector<Define>& defines) {
  std::vector<std::string> files;
  const std::string source = sourceOf(path, defines, files);
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 4096> log{};
  glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
  glDeleteShader(shader);
  std::string message = "shader " + std::string(path) + " does not compile; files:";
  for (std::size_t i = 0; i < files.size(); ++i) message += ' ' + std::to_string(i) + '=' + files[i];
  throw ShaderError(message + '\n' + log.data());
}

GLuint link(std::initializer_list<GLuint> shaders, std::string_view path) {
  const GLuint program = glCreateProgram();
  for (const GLuint shader : shaders) glAttachShader(program, shader);
  glLinkProgram(program);
  for (const GLuint shader : shaders) glDeleteShader(shader);
  GLint good = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return program;
  std::array<char, 4096> log{};
  glGetProgramInfoLog(program, log.size(), nullptr, log.data());
  glDeleteProgram(program);
  throw ShaderError("shader " + std::string(path) + " does not link\n" + log.data());
}

}  // namespace

ShaderProgram ShaderProgram::compute(std::string_view path, const std::vector<Define>& defines) {
  ShaderProgram program;
  program.name_ = link({compile(GL_COMPUTE_SHADER, path, defines)}, path);
  return program;
}

ShaderProgram ShaderProgram::graphics(std::string_view vertexPath, std::string_view fragmentPath) {
  ShaderProgram program;
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexPath, {});
  program.name_ = link({vertex, compile(GL_FRAGMENT_SHADER, fragmentPath, {})}, fragmentPath);
  return program;
}

ShaderProgram::~ShaderProgram() {
  if (name_) glDeleteProgram(name_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : name_(std::exchange(other.name_, 0)), locations_(std::move(other.locations_)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(locations_, other.locations_);
  return *this;
}

int ShaderProgram::location(const char* uniform) {
  const auto [at, isNew] = locations_.try_emplace(uniform, -1);
  if (isNew) at->second = glGetUniformLocation(name_, elementName(uniform).c_str());
  if (isNew && at->second < 0) at->second = glGetUniformLocation(name_, uniform);  // samplers and images
  return at->second;
}

void ShaderProgram::set(const char* u, int v) { glProgramUniform1i(name_, location(u), v); }
void ShaderProgram::set(const char* u, float v) { glProgramUniform1f(name_, location(u), v); }
void ShaderProgram::set(const char* u, glm::ivec2 v) { glProgramUniform2i(name_, location(u), v.x, v.y); }
void ShaderProgram::set(const char* u, glm::ivec3 v) { glProgramUniform3i(name_, location(u), v.x, v.y, v.z); }
void ShaderProgram::set(const char* u, glm::vec2 v) { glProgramUniform2f(name_, location(u), v.x, v.y); }
void ShaderProgram::set(const char* u, glm::vec3 v) { glProgramUniform3f(name_, location(u), v.x, v.y, v.z); }
void ShaderProgram::set(const char* u, glm::vec4 v) { glProgramUniform4f(name_, location(u), v.x, v.y, v.z, v.w); }
void ShaderProgram::set(const char* u, const glm::mat3& v) {
  glProgramUniformMatrix3fv(name_, location(u), 1, GL_FALSE, &v[0][0]);
}

ShaderProgram& ShaderVariants::get(const std::vector<Define>& defines) {
  std::string key;
  for (const Define& define : defines) key += define.name + '=' + std::to_string(define.value) + ';';
  const auto at = programs_.find(key);
  return at != programs_.end() ? at->second
                               : programs_.emplace(key, ShaderProgram::compute(path_, defines)).first->second;
}

namespace {

void dispatchGroups(glm::ivec2 size, glm::ivec2 groupSize) {
  const glm::ivec2 groups = (size + groupSize - 1) / groupSize;
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

/// To everything after: other shaders, textures read back, buffers.
void makeWritesVisible() {
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace

void ShaderProgram::dispatch(glm::ivec2 size, glm::ivec2 groupSize) const {
  glUseProgram(name_);
  dispatchGroups(size, groupSize);
  makeWritesVisible();
  glUseProgram(0);
}

void ShaderProgram::dispatch(std::span<const Region> regions) {
  glUseProgram(name_);
  for (const Region& region : regions) {
    set("pixelOrigin", region.origin);
    dispatchGroups(region.size, {8, 8});
  }
  makeWritesVisible();
  glUseProgram(0);
}

void ShaderProgram::dispatchIndirect(const Buffer& groups) const {
  glUseProgram(name_);
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.name());
  glDispatchComputeIndirect(0);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
  makeWritesVisible();
  glUseProgram(0);
}

void ShaderProgram::drawFullScreen() const {
  GLuint vertexArray = 0;
  glCreateVertexArrays(1, &vertexArray);  // core profile wants one bound; vertex arrays are not shared between contexts
  GLint previous = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previous);
  glBindVertexArray(vertexArray);
  glUseProgram(name_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glUseProgram(0);
  glBindVertexArray(static_cast<GLuint>(previous));
  glDeleteVertexArrays(1, &vertexArray);
}

}  // namespace fenestra::gl
