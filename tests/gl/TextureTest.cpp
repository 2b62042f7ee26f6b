#include "rendering/gl/Texture.h"

#include <gtest/gtest.h>

namespace fenestra::tests::textureTest {
namespace {

TEST(TextureSizes, WithoutPowersOfTwoAreTheLeastThatAreAsLarge) {
  EXPECT_EQ(gl::withoutPowersOfTwo({1, 2}), glm::ivec2(3, 3));
  EXPECT_EQ(gl::withoutPowersOfTwo({3, 4}), glm::ivec2(3, 5));
  EXPECT_EQ(gl::withoutPowersOfTwo({512, 511}), glm::ivec2(513, 511));
  EXPECT_EQ(gl::withoutPowersOfTwo({63, 65}), glm::ivec2(63, 65));
}

}  // namespace
}  // namespace fenestra::tests::textureTest
