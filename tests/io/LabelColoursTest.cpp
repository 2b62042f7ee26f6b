// Default colours by name, in the terms of four label collections.

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "io/LabelColours.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::labelColoursTest {
namespace {

bool isKnown(const std::string& name) { return io::labelColour(1, name) != defaultLabelColour(1); }
glm::dvec3 colour(const std::string& name) { return io::labelColour(1, name); }

TEST(LabelColours, SidesAndSpellingsMakeNoDifference) {
  for (const auto& [a, b] :
       std::vector<std::pair<std::string, std::string>>{{"kidney_left", "kidney_right"},            // TotalSegmentator
                                                        {"kidney_left", "Left kidney"},             // 3D Slicer
                                                        {"Frontal_Sup_L", "Frontal_Sup_R"},         // AAL
                                                        {"Left-Hippocampus", "Right-Hippocampus"},  // FreeSurfer
                                                        {"Left-Hippocampus", "Hippocampus_R"},
                                                        {"ctx-lh-precentral", "ctx-rh-precentral"},
                                                        {"ParaHippocampal_L", "parahippocampal"},
                                                        {"vertebrae_L1", "Vertebra L1"},
                                                        {"rib_left_7", "rib_right_7"},
                                                        {"lungs", "lung"}}) {
    EXPECT_TRUE(isKnown(a)) << a;
    EXPECT_EQ(colour(a), colour(b)) << a << " and " << b;
  }
}

TEST(LabelColours, FollowTheConventionOfAtlases) {
  const auto isRed = [](glm::dvec3 c) { return c.r > 1.5 * c.g && c.r > 1.5 * c.b; };
  const auto isBlue = [](glm::dvec3 c) { return c.b > 1.2 * c.g && c.b > 1.5 * c.r; };
  for (const char* name : {"aorta", "common_carotid_artery_left", "Hepatic arteries"})
    EXPECT_TRUE(isRed(colour(name))) << name;
  for (const char* name : {"inferior_vena_cava", "iliac_vena_left", "Hepatic veins"})
    EXPECT_TRUE(isBlue(colour(name))) << name;
  // The longest fit counts: a chamber of the heart is no ventricle of the brain.
  EXPECT_NE(colour("heart_ventricle_left"), colour("Left-Lateral-Ventricle"));
  EXPECT_FALSE(isBlue(colour("pulmonary_vein"))) << "it carries oxygenated blood";
}

TEST(LabelColours, PartsOfOneStructureDiffer) {
  EXPECT_NE(colour("vertebrae_L1"), colour("vertebrae_L2"));
  EXPECT_NE(colour("rib_left_3"), colour("rib_left_4"));
  EXPECT_NE(colour("Frontal_Sup_L"), colour("Frontal_Mid_L"));
}

TEST(LabelColours, UnknownNamesKeepTheColourOfTheirValue) {
  for (const char* name : {"", "label 5", "segment_1", "Struktur", "spleenlike"})
    EXPECT_EQ(io::labelColour(5, name), defaultLabelColour(5)) << name;
}

void expectAllKnown(const std::filesystem::path& table) {
  std::ifstream lines(table);
  int names = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    int value = 0;
    std::string name;
    if (!(words >> value >> name)) continue;
    EXPECT_TRUE(isKnown(name)) << name;
    ++names;
  }
  EXPECT_GT(names, 50);
}

TEST(LabelColours, KnowEveryStructureOfTheTorso) {
  FENESTRA_TEST_DATA_OR_SKIP(table, "labelled/totalsegmentator-torso/labels.tsv");
  expectAllKnown(table);
}

TEST(LabelColours, KnowEveryRegionOfTheBrain) {
  FENESTRA_TEST_DATA_OR_SKIP(table, "labelled/brain-colin27/aal.nii.txt");
  expectAllKnown(table);
}

}  // namespace
}  // namespace fenestra::tests::labelColoursTest
