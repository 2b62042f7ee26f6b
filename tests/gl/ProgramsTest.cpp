// Every program that the renderer and camera placement link, in every variant, under both schedules: that it is GLSL
// that others accept, that it fits what every OpenGL 4.5 driver must offer, and that neither a schedule nor drawing
// a tile at a time changes the picture.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include <unistd.h>

#include "rendering/gpu/Uniforms.h"
#include "tests/gl/DrawnKinds.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::programsTest {
namespace {

namespace fs = std::filesystem;

class ProgramsTest : public GlTest {
 protected:
  static const DrawnKinds& drawn() {
    static const DrawnKinds all = drawKinds(Chosen::CoveringProperties);
    return all;
  }
  static const Programs& programs() { return drawn().programs; }
};

/// Bytes of the `shared` arrays that a source declares.
int sharedBytes(const std::string& source) {
  const std::map<std::string, int> sizes{{"float", 4}, {"int", 4},   {"uint", 4},
                                         {"vec2", 8},  {"vec4", 16}, {"ivec4", 16}};
  const std::regex declaration(R"(\nshared (\w+) \w+\[(\d+)\];)");
  int sum = 0;
  for (std::sregex_iterator at(source.begin(), source.end(), declaration), end; at != end; ++at)
    sum += sizes.at((*at)[1]) * std::stoi((*at)[2]);
  return sum;
}

TEST_F(ProgramsTest, Thorough_EveryShaderIsLinkedInSeveralVariants) {
  std::map<std::string, int> variants;
  for (const auto& [source, linked] : programs()) ++variants[linked.path];
  for (const char* path :
       {"HitPoints.comp",         "PullPushAnalysis.comp",    "PullPushSynthesis.comp", "FocusMask.comp",
        "FocusTiles.comp",        "DistanceRows.comp",        "DistanceColumns.comp",   "RayStart.comp",
        "EditMap.comp",           "ProtectedLayer.comp",      "ContextLayer.comp",      "Composite.comp",
        "ConeDepths.comp",        "ConeStart.comp",           "Occluders.comp",         "Occlusion.comp",
        "OcclusionNodes.comp",    "EdgePixels.comp",          "EdgeMeans.comp",         "CandidateHits.comp",
        "CandidateOutlines.comp", "CandidateVisibility.comp", "CandidateEnds.comp",     "Walls.comp",
        "ContextLines.comp"})
    EXPECT_GE(variants[path], 2) << path << ": one for each schedule at least";
  for (const char* path : {"QuincunxBetween.comp", "CentresBetween.comp", "SidesBetween.comp", "CandidateEdges.comp"})
    EXPECT_GE(variants[path], 1) << path;
  for (const char* path : {"CandidateAreas.comp", "CandidateSums.comp"})
    EXPECT_GE(variants[path], 2) << path << ": with and without end faces";
  EXPECT_GE(variants["FocusLayer.comp"], 80);
  EXPECT_GE(variants["FocusLayerApart.comp"], 8);
  EXPECT_GE(variants["FocusLayerExploded.comp"], 8);
}

TEST_F(ProgramsTest, Thorough_EachStaysWithinWhatOpenGlGuarantees) {
  // OpenGL 4.5 core, tables 23.60 to 23.72: the least that a driver may offer a compute shader.
  for (const auto& [source, linked] : programs()) {
    const gl::ProgramResources& used = linked.resources;
    EXPECT_LE(used.images, 8) << linked.path;
    EXPECT_LE(used.samplers, 16) << linked.path;
    EXPECT_LE(used.storageBlocks, 8) << linked.path;
    EXPECT_LE(used.uniformBlocks, 1) << linked.path << ": shaders/lib/Uniforms.glsl is the one";
    EXPECT_LE(used.groupSize.x * used.groupSize.y * used.groupSize.z, 1024) << linked.path;
    EXPECT_LE(sharedBytes(source), 32 * 1024) << linked.path;
  }
}

/// Files of a program's sources in a folder of their own, which ends with this.
class SourceFiles {
 public:
  explicit SourceFiles(const Programs& programs)
      : folder_(fs::path(::testing::TempDir()) / ("fenestra-programs-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    for (const auto& [source, linked] : programs) {
      const bool drawn = linked.path == "Present.frag";
      files_.push_back({folder_ / (std::to_string(files_.size()) + (drawn ? ".frag" : ".comp")), linked.path});
      // Line directives with file numbers are translated by our own errors; the validator shows its own lines.
      std::ofstream(files_.back().first) << source;
    }
  }
  ~SourceFiles() { fs::remove_all(folder_); }
  SourceFiles(const SourceFiles&) = delete;
  SourceFiles& operator=(const SourceFiles&) = delete;

  const fs::path& folder() const { return folder_; }
  /// The file of a program, and the shader that it comes from.
  const std::vector<std::pair<fs::path, std::string>>& files() const { return files_; }

 private:
  fs::path folder_;
  std::vector<std::pair<fs::path, std::string>> files_;
};

bool hasReferenceCompiler() { return std::system("glslangValidator --version > /dev/null") == 0; }

TEST_F(ProgramsTest, Thorough_EachPassesTheReferenceCompiler) {
  ASSERT_TRUE(hasReferenceCompiler()) << "install glslang-tools";
  const SourceFiles sources(programs());
  std::string files;
  for (const auto& [file, path] : sources.files()) files += ' ' + file.string();
  const std::string log = (sources.folder() / "log").string();
  const int status = std::system(("glslangValidator" + files + " > " + log + " 2>&1").c_str());
  std::ifstream stream(log);
  std::string line, errors;
  while (std::getline(stream, line))
    if (line.find("ERROR") != std::string::npos) errors += line + '\n';
  EXPECT_EQ(status, 0) << errors;
}

// NVIDIA's driver counts images that a program declares, also those that it does not use.
TEST_F(ProgramsTest, Thorough_EachDeclaresNoMoreImagesThanOpenGlGuarantees) {
  ASSERT_TRUE(hasReferenceCompiler()) << "install glslang-tools";
  const SourceFiles sources(programs());
  std::string files;
  for (const auto& [file, path] : sources.files()) files += ' ' + file.string();
  const std::string expanded = (sources.folder() / "expanded").string();
  ASSERT_EQ(std::system(("glslangValidator -E" + files + " > " + expanded).c_str()), 0);
  std::ifstream stream(expanded);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  // The preprocessor writes one source after the other; each starts with its version.
  const std::regex declaration(R"((#version)|uniform\s+(readonly |writeonly )?\s*[iu]?image[23]D\s+(\w+))");
  std::vector<std::vector<std::string>> images;
  for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
    if ((*at)[1].matched)
      images.emplace_back();
    else
      images.back().push_back((*at)[3]);
  ASSERT_EQ(images.size(), sources.files().size());
  std::size_t most = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    EXPECT_LE(images[i].size(), 8) << sources.files()[i].second << ": " << ::testing::PrintToString(images[i]);
    most = std::max(most, images[i].size());
  }
  EXPECT_GE(most, 7) << "the declarations are no longer found";
}

/// Offsets by name of a block's members on this side.
using Layout = std::map<std::string, std::size_t>;

TEST_F(ProgramsTest, Thorough_BlocksHaveTheLayoutOfTheirStructs) {
#define OFFSET(Block, member) \
  { #member, offsetof(Block, member) }
  const std::map<std::string, Layout> expected{
      {RayUniforms::name,
       {OFFSET(RayUniforms, cellsFromView), OFFSET(RayUniforms, worldFromView), OFFSET(RayUniforms, anchor),
        OFFSET(RayUniforms, distance), OFFSET(RayUniforms, halfSize), OFFSET(RayUniforms, spread),
        OFFSET(RayUniforms, depth), OFFSET(RayUniforms, pictureSize)}},
      {ClipUniforms::name, {OFFSET(ClipUniforms, planes), OFFSET(ClipUniforms, normals), OFFSET(ClipUniforms, grey)}},
      {VolumeUniforms::name, {OFFSET(VolumeUniforms, dims)}},
      {TransferUniforms::name,
       {OFFSET(TransferUniforms, firstMaterial), OFFSET(TransferUniforms, lastMaterial), OFFSET(TransferUniforms, map),
        OFFSET(TransferUniforms, visibleEntries), OFFSET(TransferUniforms, firstLevel)}},
      {FocusUniforms::name,
       {OFFSET(FocusUniforms, material), OFFSET(FocusUniforms, range), OFFSET(FocusUniforms, paletteOrigin),
        OFFSET(FocusUniforms, smoothOrigin), OFFSET(FocusUniforms, table),
        OFFSET(FocusUniforms, worldFromIndexGradient)}},
      {LightUniforms::name,
       {OFFSET(LightUniforms, direction), OFFSET(LightUniforms, ambient), OFFSET(LightUniforms, diffuse),
        OFFSET(LightUniforms, specular), OFFSET(LightUniforms, shininess), OFFSET(LightUniforms, meanIncidence),
        OFFSET(LightUniforms, gradientOrigin), OFFSET(LightUniforms, certainLength), OFFSET(LightUniforms, lastNode),
        OFFSET(LightUniforms, nodesPerVoxel)}},
      {OccludersUniforms::name,
       {OFFSET(OccludersUniforms, viewFromCells), OFFSET(OccludersUniforms, offset),
        OFFSET(OccludersUniforms, perDepth), OFFSET(OccludersUniforms, dims), OFFSET(OccludersUniforms, nearest),
        OFFSET(OccludersUniforms, side), OFFSET(OccludersUniforms, width)}},
      {OcclusionUniforms::name,
       {OFFSET(OcclusionUniforms, dims), OFFSET(OcclusionUniforms, around), OFFSET(OcclusionUniforms, strength),
        OFFSET(OcclusionUniforms, towardsLight)}},
      {IntegralUniforms::name,
       {OFFSET(IntegralUniforms, leastTransmittance), OFFSET(IntegralUniforms, maxError),
        OFFSET(IntegralUniforms, cutFaceDepth), OFFSET(IntegralUniforms, cutFaceShare),
        OFFSET(IntegralUniforms, perGap)}},
      {OpeningCameraUniforms::name,
       {OFFSET(OpeningCameraUniforms, viewFromWorld), OFFSET(OpeningCameraUniforms, offset),
        OFFSET(OpeningCameraUniforms, perDepth), OFFSET(OpeningCameraUniforms, halfSize),
        OFFSET(OpeningCameraUniforms, pictureSize), OFFSET(OpeningCameraUniforms, nearest)}},
      {ConeUniforms::name,
       {OFFSET(ConeUniforms, origin), OFFSET(ConeUniforms, tops), OFFSET(ConeUniforms, slope),
        OFFSET(ConeUniforms, perDepth)}},
      {DerivativeUniforms::name,
       {OFFSET(DerivativeUniforms, worldFromDerivative), OFFSET(DerivativeUniforms, factor),
        OFFSET(DerivativeUniforms, scale)}},
      {CutawayUniforms::name, {OFFSET(CutawayUniforms, widths), OFFSET(CutawayUniforms, borderColour)}},
      {ContextLayerUniforms::name,
       {OFFSET(ContextLayerUniforms, colour), OFFSET(ContextLayerUniforms, strength),
        OFFSET(ContextLayerUniforms, curvatureWeight), OFFSET(ContextLayerUniforms, silhouetteWeight),
        OFFSET(ContextLayerUniforms, illuminationWeight), OFFSET(ContextLayerUniforms, valueWeight),
        OFFSET(ContextLayerUniforms, curvatureScale), OFFSET(ContextLayerUniforms, saturation),
        OFFSET(ContextLayerUniforms, leastLine)}},
      {WallUniforms::name,
       {OFFSET(WallUniforms, plane), OFFSET(WallUniforms, across), OFFSET(WallUniforms, down),
        OFFSET(WallUniforms, extent), OFFSET(WallUniforms, metric)}},
      {CandidateUniforms::name,
       {OFFSET(CandidateUniforms, sphereCentre), OFFSET(CandidateUniforms, sphereRadius),
        OFFSET(CandidateUniforms, focusLower), OFFSET(CandidateUniforms, focusUpper)}}};
#undef OFFSET
  std::map<std::string, int> compared;
  for (const auto& [source, linked] : programs())
    for (const auto& [block, members] : linked.blocks) {
      // ShaderProgram takes a struct to start at its first active member, so a driver must leave out none.
      if (!members.empty()) {
        EXPECT_EQ(members.size(), expected.at(block).size()) << block;
      }
      for (const auto& [member, offset] : members) {
        ASSERT_TRUE(expected.at(block).contains(member)) << block << '.' << member;
        EXPECT_EQ(static_cast<std::size_t>(offset), expected.at(block).at(member)) << block << '.' << member;
        ++compared[block];
      }
    }
  for (const std::string& block : blockNames) EXPECT_GT(compared[block], 0) << block << " is in no program";
}

#ifndef NDEBUG
TEST_F(ProgramsTest, UnknownNamesAndWrongTypesAreAsserted) {
  gl::ShaderProgram program = gl::ShaderProgram::compute("FocusTiles.comp", {{}, {scheduleChoice(Schedule::Plain)}});
  program.set("reach", 1);
  EXPECT_DEATH(program.set("reached", 1), "declares no uniform");
  EXPECT_DEATH(program.set("reach", 1.0f), "Assertion");
}

TEST_F(ProgramsTest, WhatASourceDoesNotUseIsAsserted) {
  const gl::Variant needed{{}, {scheduleChoice(Schedule::Plain)}};
  EXPECT_DEATH(gl::ShaderProgram::compute("FocusTiles.comp", needed + gl::Variant{{{"FOCUS", 1}}, {}}),
               "a define is not used");
  EXPECT_DEATH(gl::ShaderProgram::compute("FocusTiles.comp", needed + needed), "a choice is not used, or given twice");
  EXPECT_DEATH(
      gl::ShaderProgram::compute("FocusTiles.comp", needed + gl::Variant{{}, {{"fading", "lib/fading/None.glsl"}}}),
      "a choice is not used");
}
#endif

TEST_F(ProgramsTest, RunOnTheDriverThatTheTestAsksFor) {
  const char* wanted = std::getenv("MESA_LOADER_DRIVER_OVERRIDE");
  if (wanted) {
    EXPECT_TRUE(gl::description().starts_with(wanted)) << gl::description();
  }
}

TEST_F(ProgramsTest, AMissingChoiceIsAnErrorThatNamesIt) {
  try {
    gl::ShaderProgram::compute("FocusTiles.comp");
    FAIL();
  } catch (const gl::ShaderError& error) {
    EXPECT_NE(std::string(error.what()).find("<schedule>"), std::string::npos) << error.what();
  }
}

void expectNoFaults(const DrawnKinds& drawn) {
  for (const std::string& fault : drawn.tileFaults) ADD_FAILURE() << "in tiles: " << fault;
  for (const std::string& fault : drawn.scheduleFaults) ADD_FAILURE() << "schedules: " << fault;
}

TEST_F(ProgramsTest, Thorough_TilesAndSchedulesDrawTheSamePictureForEachPropertyOfAScene) {
  expectNoFaults(drawn());
  EXPECT_GE(drawn().drawn, 20u);
  EXPECT_LT(drawn().drawn, drawn().kinds);
}

TEST_F(ProgramsTest, Exhaustive_TilesAndSchedulesDrawTheSamePictureInEveryKindOfScene) {
  const DrawnKinds every = drawKinds(Chosen::All);
  expectNoFaults(every);
  EXPECT_EQ(every.drawn, every.kinds);
}

}  // namespace
}  // namespace fenestra::tests::programsTest
