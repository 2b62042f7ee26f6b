// The pre-integrated table against Simpson's rule over segments, and its entries that must be exact.

#include "rendering/gpu/PreIntegration.h"

#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "rendering/gpu/TransferTables.h"

namespace fenestra::tests::preIntegrationTest {
namespace {

constexpr int size = 16384;
constexpr double longest = 2.0;  // mm

/// As levelOf() of shaders/lib/PreIntegration.glsl has it.
float perEntryOf(const PreIntegration& table, int level) {
  constexpr int dropped = 23 - PreIntegration::mantissaBits;
  return std::bit_cast<float>(((table.firstLevel + level) << dropped) + (1 << (dropped - 1)));
}

glm::dvec4 texel(const PreIntegration& table, int row, int level) {
  return glm::dvec4(table.texels.at(static_cast<std::size_t>(row * PreIntegration::levels + level)));
}

/// Colour and opacity between two rows that the table tells, looking from the first to the second.
glm::dvec4 segmentOf(const PreIntegration& table, int first, int second, int level) {
  const int direction = second > first ? 0 : table.rows;
  const glm::dvec4 front = texel(table, first + direction, level), back = texel(table, second + direction, level);
  const double passed = std::exp(-perEntryOf(table, level) * std::abs(back.a - front.a));
  return glm::dvec4(glm::dvec3(front) - passed * glm::dvec3(back), 1.0 - passed);
}

/// The emission–absorption integral over the same, front to back in short pieces of their middle's material.
glm::dvec4 integrated(const TransferFunction& function, ValueRange span, double first, double second, double perEntry) {
  constexpr int pieces = 200'000;
  const double perValue = (span.high - span.low) / (size - 1), length = std::abs(second - first) / pieces * perEntry;
  glm::dvec4 sum(0.0);
  for (int i = 0; i < pieces; ++i) {
    const double entry = first + (second - first) * (i + 0.5) / pieces;
    const OpticalProperties at = function.evaluate(span.low + perValue * entry);
    const double opacity = -std::expm1(-at.extinction * length);
    sum += (1.0 - sum.a) * opacity * glm::dvec4(at.colour, 1.0);
  }
  return sum;
}

TransferFunction someFunction() {
  return {{{-100.0, {{1.0, 0.2, 0.1}, 0.0}},
           {40.0, {{0.1, 0.9, 0.3}, 0.8}},
           {60.0, {{0.2, 0.1, 1.0}, 0.05}},
           {300.0, {{0.9, 0.9, 0.2}, 2.0}}}};
}

TEST(PreIntegration, SegmentsAreTheIntegralOverThem) {
  const TransferFunction function = someFunction();
  const ValueRange span = tableSpan(function, {}, size);
  const PreIntegration table(function, span, size, longest);
  std::mt19937 random(7);
  for (int i = 0; i < 24; ++i) {
    const int first = std::uniform_int_distribution(0, table.rows - 2)(random);
    const int second = std::uniform_int_distribution(0, table.rows - 2)(random);
    const int level = std::uniform_int_distribution(0, PreIntegration::levels - 1)(random);
    if (first == second) continue;
    const glm::dvec4 found = segmentOf(table, first, second, level);
    const glm::dvec4 expected = integrated(function, span, PreIntegration::spacing * first,
                                           PreIntegration::spacing * second, perEntryOf(table, level));
    // Each row's entries are of one material, and float32 texels are subtracted.
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(found[channel], expected[channel], 2e-4) << first << " to " << second << ", level " << level;
  }
}

TEST(PreIntegration, LevelsReachTheLongestSegmentOfNeighbouringRows) {
  const TransferFunction function = someFunction();
  const PreIntegration table(function, tableSpan(function, {}, size), size, longest);
  const double last = perEntryOf(table, PreIntegration::levels - 1),
               before = perEntryOf(table, PreIntegration::levels - 2);
  EXPECT_LT(std::abs(std::log2(last / (longest / PreIntegration::spacing))), 1.0 / PreIntegration::perOctave);
  EXPECT_NEAR(perEntryOf(table, PreIntegration::levels - 1 - PreIntegration::perOctave), 0.5 * last, 1e-9);
  EXPECT_LT(before, last);
}

TEST(PreIntegration, EmptyValuesAreExactlyEmpty) {
  // Clear from 0 to 100, between colours.
  const TransferFunction function{{{-100.0, {{1.0, 0.0, 0.0}, 1.0}},
                                   {0.0, {{1.0, 0.0, 0.0}, 0.0}},
                                   {100.0, {{0.0, 0.0, 1.0}, 0.0}},
                                   {200.0, {{0.0, 0.0, 1.0}, 1.0}}}};
  const ValueRange span = tableSpan(function, {}, size);
  const PreIntegration table(function, span, size, longest);
  const auto rowOf = [&](double value) {
    return static_cast<int>((value - span.low) / (span.high - span.low) * (size - 1) / PreIntegration::spacing);
  };
  const int first = rowOf(0.0) + 1, last = rowOf(100.0);
  ASSERT_GT(last, first + 100);
  for (int level = 0; level < PreIntegration::levels; ++level)
    for (const int direction : {0, table.rows})
      for (int row = first; row < last; ++row)
        ASSERT_EQ(texel(table, row + direction, level), texel(table, row + 1 + direction, level)) << row;
}

TEST(PreIntegration, AFunctionThatShowsNothingIsBlack) {
  for (const TransferFunction& function : {TransferFunction(), TransferFunction{{{5.0, {glm::dvec3(1.0), 0.0}}}}}) {
    const PreIntegration table(function, tableSpan(function, {0.0, 1.0}, size), size, longest);
    for (const glm::vec4& each : table.texels) ASSERT_EQ(each, glm::vec4(0.0f));
  }
}

TEST(PreIntegration, WhatLiesBeyondAnEndIsOfItsColour) {
  const TransferFunction function = someFunction();  // clear below, dense above
  const PreIntegration table(function, tableSpan(function, {}, size), size, longest);
  for (int level = 0; level < PreIntegration::levels; ++level) {
    EXPECT_EQ(glm::dvec3(texel(table, table.rows, level)), glm::dvec3(0.0));
    EXPECT_NEAR(glm::length(glm::dvec3(texel(table, table.rows - 1, level)) - glm::dvec3(0.9, 0.9, 0.2)), 0.0, 1e-7);
  }
}

}  // namespace
}  // namespace fenestra::tests::preIntegrationTest
