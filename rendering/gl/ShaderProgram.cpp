#include "rendering/gl/ShaderProgram.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include <epoxy/gl.h>

namespace fenestra::gl {
namespace {

ShaderProgram::Listener& listener() {
  static ShaderProgram::Listener told;
  return told;
}

thread_local std::size_t programsRun = 0;

GLuint compile(GLenum stage, std::string_view path, const ShaderSource& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 4096> log{};
  glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
  glDeleteShader(shader);
  std::string message = "shader " + std::string(path) + " does not compile; files:";
  for (std::size_t i = 0; i < source.files.size(); ++i) message += ' ' + std::to_string(i) + '=' + source.files[i];
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

bool isImage(GLenum type) { return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY; }

bool isSampler(GLenum type) {
  constexpr std::array samplers{GL_SAMPLER_2D, GL_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_3D};
  return std::ranges::find(samplers, static_cast<int>(type)) != samplers.end();
}

std::string resourceName(GLuint program, GLenum interface, GLuint index) {
  std::array<char, 256> name{};
  glGetProgramResourceName(program, interface, index, name.size(), nullptr, name.data());
  return name.data();
}

int resourceCount(GLuint program, GLenum interface) {
  GLint count = 0;
  glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return count;
}

/// Splits the name of a member of the uniform block, which its own name may precede, into that of its struct and its
/// own: "rays" and "anchor" of "Uniforms.rays.anchor", "walls" and "plane" of "walls.plane[0]".
std::pair<std::string, std::string> structOf(const std::string& uniform) {
  const std::size_t last = uniform.rfind('.'), before = uniform.rfind('.', last - 1);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return {uniform.substr(first, last - first), uniform.substr(last + 1, uniform.find('[') - last - 1)};
}

template <std::size_t Count>
std::array<GLint, Count> resourceValues(GLuint program, GLenum interface, int index,
                                        const std::array<GLenum, Count>& properties) {
  std::array<GLint, Count> values{};
  glGetProgramResourceiv(program, interface, static_cast<GLuint>(index), Count, properties.data(), Count, nullptr,
                         values.data());
  return values;
}

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

ShaderProgram ShaderProgram::compute(std::string_view path, const Variant& variant) {
  ShaderProgram program;
  program.isCompute_ = true;
  ShaderSource source = sourceOf(path, variant);
  program.name_ = link({compile(GL_COMPUTE_SHADER, path, source)}, path);
  program.names_ = std::move(source.names);
  program.inspect();
  if (listener()) listener()(program, path, source.text);
  return program;
}

ShaderProgram ShaderProgram::graphics(std::string_view vertexPath, std::string_view fragmentPath) {
  ShaderProgram program;
  ShaderSource vertex = sourceOf(vertexPath, {});
  const ShaderSource fragment = sourceOf(fragmentPath, {});
  const GLuint vertexShader = compile(GL_VERTEX_SHADER, vertexPath, vertex);
  program.name_ = link({vertexShader, compile(GL_FRAGMENT_SHADER, fragmentPath, fragment)}, fragmentPath);
  program.names_ = std::move(vertex.names);
  program.names_.insert(fragment.names.begin(), fragment.names.end());
  program.inspect();
  if (listener()) listener()(program, fragmentPath, fragment.text);
  return program;
}

std::size_t ShaderProgram::firstRuns() { return programsRun; }

void ShaderProgram::listen(Listener wanted) { listener() = std::move(wanted); }

ShaderProgram::~ShaderProgram() {
  if (name_) glDeleteProgram(name_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      isCompute_(other.isCompute_),
      hasRun_(other.hasRun_),
      uniforms_(std::move(other.uniforms_)),
      textures_(std::move(other.textures_)),
      block_(std::move(other.block_)),
      names_(std::move(other.names_)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(isCompute_, other.isCompute_);
  std::swap(hasRun_, other.hasRun_);
  std::swap(uniforms_, other.uniforms_);
  std::swap(textures_, other.textures_);
  std::swap(block_, other.block_);
  std::swap(names_, other.names_);
  return *this;
}

/// Finds the active uniforms, those of the uniform block too, and gives each texture a unit of its own.
void ShaderProgram::inspect() {
  unsigned images = 0, samplers = 0;
  for (int i = 0; i < resourceCount(name_, GL_UNIFORM); ++i) {
    const auto [type, location, block] =
        resourceValues<3>(name_, GL_UNIFORM, i, {GL_TYPE, GL_LOCATION, GL_BLOCK_INDEX});
    std::string name = resourceName(name_, GL_UNIFORM, static_cast<GLuint>(i));
    if (block >= 0) {
      const auto [offset] = resourceValues<1>(name_, GL_UNIFORM, i, {GL_OFFSET});
      const auto [at, isFirst] = block_.offsets.emplace(structOf(name).first, offset);
      if (!isFirst) at->second = std::min(at->second, static_cast<std::size_t>(offset));
      continue;
    }
    const auto kind = static_cast<unsigned>(type);
    if (isImage(kind) || isSampler(kind)) {
      const unsigned unit = isImage(kind) ? images++ : samplers++;
      glProgramUniform1i(name_, location, static_cast<GLint>(unit));
      textures_.push_back({std::move(name), isImage(kind), unit});
    } else {
      uniforms_.emplace(std::move(name), Uniform{location, kind});
    }
  }
  if (resourceCount(name_, GL_UNIFORM_BLOCK) == 0) return;
  const auto [size] = resourceValues<1>(name_, GL_UNIFORM_BLOCK, 0, {GL_BUFFER_DATA_SIZE});
  glUniformBlockBinding(name_, 0, 0);
  block_.bytes.resize(static_cast<std::size_t>(size));
}

void ShaderProgram::assertDeclared([[maybe_unused]] std::string_view name) const {
  assert(names_.contains(name) && "the shader declares no uniform of this name");
}

const ShaderProgram::Uniform* ShaderProgram::find(std::string_view uniform,
                                                  [[maybe_unused]] std::initializer_list<unsigned> types) const {
  assertDeclared(uniform);
  const auto at = uniforms_.find(uniform);
  if (at == uniforms_.end()) return nullptr;
  assert(std::ranges::find(types, at->second.type) != types.end());
  return &at->second;
}

void ShaderProgram::set(std::string_view name, int value) {
  if (const Uniform* u = find(name, {GL_INT, GL_BOOL})) glProgramUniform1i(name_, u->location, value);
}
void ShaderProgram::set(std::string_view name, float value) {
  if (const Uniform* u = find(name, {GL_FLOAT})) glProgramUniform1f(name_, u->location, value);
}
void ShaderProgram::set(std::string_view name, glm::ivec2 value) {
  if (const Uniform* u = find(name, {GL_INT_VEC2})) glProgramUniform2i(name_, u->location, value.x, value.y);
}
void ShaderProgram::set(std::string_view name, glm::ivec3 value) {
  if (const Uniform* u = find(name, {GL_INT_VEC3})) glProgramUniform3i(name_, u->location, value.x, value.y, value.z);
}
void ShaderProgram::set(std::string_view name, glm::vec2 value) {
  if (const Uniform* u = find(name, {GL_FLOAT_VEC2})) glProgramUniform2f(name_, u->location, value.x, value.y);
}
void ShaderProgram::set(std::string_view name, glm::vec3 value) {
  if (const Uniform* u = find(name, {GL_FLOAT_VEC3})) glProgramUniform3f(name_, u->location, value.x, value.y, value.z);
}

void ShaderProgram::setStruct(std::string_view name, std::span<const std::byte> bytes) {
  assertDeclared(name);
  const auto at = block_.offsets.find(name);
  if (at == block_.offsets.end()) return;
  assert(at->second + bytes.size() <= block_.bytes.size());
  const std::span<std::byte> held = std::span(block_.bytes).subspan(at->second, bytes.size());
  if (std::ranges::equal(bytes, held)) return;
  std::ranges::copy(bytes, held.begin());
  block_.isUploaded = false;
}

void ShaderProgram::bindBlock() {
  if (block_.bytes.empty()) return;
  if (!block_.buffer) {
    block_.buffer = Buffer(block_.bytes);
    constexpr std::string_view label = "uniform block";  // for debuggers, and for who counts what pictures hold
    glObjectLabel(GL_BUFFER, block_.buffer.name(), static_cast<GLsizei>(label.size()), label.data());
  } else if (!block_.isUploaded) {
    block_.buffer.write(block_.bytes);
  }
  block_.isUploaded = true;
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, block_.buffer.name());
}

void ShaderProgram::bind(std::string_view name, const Texture& texture, Access access) {
  assertDeclared(name);
  const auto at = std::ranges::find(textures_, name, &TextureUnit::name);
  if (at == textures_.end()) return;
  at->texture = texture.name();
  at->format = texture.format();
  at->access = access;
}

/// Makes the program current, with its textures and uniforms.
void ShaderProgram::use() {
  if (!std::exchange(hasRun_, true)) ++programsRun;
  glUseProgram(name_);
  for (const TextureUnit& bound : textures_) {
    if (bound.isImage) {
      const GLenum mode = bound.access == Access::Read    ? GL_READ_ONLY
                          : bound.access == Access::Write ? GL_WRITE_ONLY
                                                          : GL_READ_WRITE;
      glBindImageTexture(bound.unit, bound.texture, 0, GL_TRUE, 0, mode, internalFormat(bound.format));
    } else {
      glBindTextureUnit(bound.unit, bound.texture);
    }
  }
  bindBlock();
}

void ShaderProgram::dispatch(glm::ivec2 size, glm::ivec2 groupSize) {
  use();
  dispatchGroups(size, groupSize);
  makeWritesVisible();
  glUseProgram(0);
}

void ShaderProgram::dispatch(std::span<const Region> regions) {
  use();
  for (const Region& region : regions) {
    set("pixelOrigin", region.origin);
    dispatchGroups(region.size, {8, 8});
  }
  makeWritesVisible();
  glUseProgram(0);
}

void ShaderProgram::dispatchIndirect(const Buffer& groups) {
  use();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.name());
  glDispatchComputeIndirect(0);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
  makeWritesVisible();
  glUseProgram(0);
}

ProgramResources ShaderProgram::resources() const {
  ProgramResources used;
  for (const TextureUnit& texture : textures_) ++(texture.isImage ? used.images : used.samplers);
  used.storageBlocks = resourceCount(name_, GL_SHADER_STORAGE_BLOCK);
  used.uniformBlocks = resourceCount(name_, GL_UNIFORM_BLOCK);
  if (isCompute_) glGetProgramiv(name_, GL_COMPUTE_WORK_GROUP_SIZE, &used.groupSize.x);
  return used;
}

std::vector<std::pair<std::string, int>> ShaderProgram::structLayout(std::string_view name) const {
  std::vector<std::pair<std::string, int>> members;
  const auto at = block_.offsets.find(name);
  if (at == block_.offsets.end()) return members;
  for (int i = 0; i < resourceCount(name_, GL_UNIFORM); ++i) {
    const auto [block, offset] = resourceValues<2>(name_, GL_UNIFORM, i, {GL_BLOCK_INDEX, GL_OFFSET});
    if (block < 0) continue;
    const auto [parent, member] = structOf(resourceName(name_, GL_UNIFORM, static_cast<GLuint>(i)));
    if (parent == name) members.emplace_back(member, offset - static_cast<int>(at->second));
  }
  return members;
}

ShaderProgram& ShaderVariants::get(const Variant& variant) {
  std::string key = path_ + ';';
  for (const Define& define : variant.defines) key += define.name + '=' + std::to_string(define.value) + ';';
  for (const Choice& choice : variant.choices) key += choice.name + '=' + choice.file + ';';
  const auto at = programs_->find(key);
  return at != programs_->end() ? at->second
                                : programs_->emplace(key, ShaderProgram::compute(path_, variant)).first->second;
}

void ShaderProgram::drawFullScreen() {
  GLuint vertexArray = 0;
  glCreateVertexArrays(1, &vertexArray);  // core profile wants one bound; vertex arrays are not shared between contexts
  GLint previous = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previous);
  glBindVertexArray(vertexArray);
  use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glUseProgram(0);
  // Another context may delete the textures, and drivers fail on views of them that are still bound here.
  for (const TextureUnit& bound : textures_) glBindTextureUnit(bound.unit, 0);
  glBindVertexArray(static_cast<GLuint>(previous));
  glDeleteVertexArrays(1, &vertexArray);
}

}  // namespace fenestra::gl
