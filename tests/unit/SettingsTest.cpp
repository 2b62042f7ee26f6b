// Declarations of settings: every member has one, its default is in its range, and its name is its own.

#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "rendering/settings/Settings.h"

namespace fenestra::tests::settingsTest {
namespace {

/// Stands for any member in an aggregate's braces.
struct Anything {
  template <class T>
  operator T() const {
    return T();  // never runs; clang asks for it where a member forwards it
  }
};

/// Number of members of an aggregate: the most that its braces take.
template <class T, class... Members>
constexpr std::size_t memberCount() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return memberCount<T, Members..., Anything>();
  else
    return sizeof...(Members);
}

template <class T>
constexpr std::size_t declared = std::tuple_size_v<decltype(settingsOf<T>)>;

struct Three {
  double a;
  glm::dvec3 b;
  std::string c;
};
static_assert(memberCount<Three>() == 3);

// A new member must be declared in rendering/settings/Settings.h or its method's folder, or be one of those that are no
// settings.
static_assert(declared<Method> == 1, "the kind; methods have theirs");
static_assert(declared<Cutaway> == memberCount<Cutaway>());
static_assert(declared<ContextLayer> == memberCount<ContextLayer>());
static_assert(declared<Shading> == memberCount<Shading>());
static_assert(declared<FocusAppearance> + 1 == memberCount<FocusAppearance>(), "all but the function");
static_assert(declared<ValueFocus> + 1 == memberCount<ValueFocus>(), "all but the range");
static_assert(declared<ContextFunction> + 3 == memberCount<ContextFunction>(), "all but the function and its source");
static_assert(declared<BrushStroke> + 1 == memberCount<BrushStroke>(), "all but the anchors");
static_assert(declared<Look> + 11 == memberCount<Look>(),
              "all but the parts above, the focus, the labels, clipping, the strokes and the removals");

template <class... M>
constexpr bool allDeclared(MethodTypes<M...>) {
  return ((declared<M> == memberCount<M>()) && ...);
}
static_assert(allDeclared(Methods{}));

template <class T>
class SettingsOf : public testing::Test {};
template <class... M>
auto ownersWith(MethodTypes<M...>) -> testing::Types<M..., Method, Cutaway, ContextLayer, Shading, FocusAppearance,
                                                     ValueFocus, ContextFunction, Look, BrushStroke>;
using Owners = decltype(ownersWith(Methods{}));
TYPED_TEST_SUITE(SettingsOf, Owners);

TYPED_TEST(SettingsOf, HaveDefaultsAndSlidersInTheirRanges) {
  forEachSetting<TypeParam>([](const auto& setting) {
    const auto usual = TypeParam{}.*setting.member;
    if constexpr (std::is_arithmetic_v<decltype(usual)> && !std::same_as<decltype(usual), const bool>) {
      EXPECT_TRUE(setting.range.contains(static_cast<double>(usual))) << setting.key;
      EXPECT_LE(setting.range.low, setting.slider.low) << setting.key;
      EXPECT_GE(setting.range.high, setting.slider.high) << setting.key;
      EXPECT_LT(setting.slider.low, setting.slider.high) << setting.key;
      if (setting.step > 0.0) {
        EXPECT_TRUE(setting.slider.contains(static_cast<double>(usual))) << setting.key;
        EXPECT_LE(setting.step, setting.slider.high - setting.slider.low) << setting.key;
      }
    }
  });
}

TYPED_TEST(SettingsOf, HaveKeysAndDescriptionsOfTheirOwn) {
  std::set<std::string> keys, descriptions;
  forEachSetting<TypeParam>([&](const auto& setting) {
    EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
    EXPECT_TRUE(descriptions.insert(setting.description).second) << setting.key;
    EXPECT_FALSE(std::string(setting.name).empty()) << setting.key;
    EXPECT_FALSE(std::string(setting.description).empty()) << setting.key;
    EXPECT_EQ(&settingOf(setting.member), &setting) << setting.key;
  });
}

/// Sessions hold the parameters of all methods side by side.
TEST(Settings, KeysOfMethodsAreNamedOnce) {
  std::set<std::string> keys{settingOf(&Method::kind).key};
  forEachMethod([&]<class M>() {
    forEachSetting<M>([&](const auto& setting) { EXPECT_TRUE(keys.insert(setting.key).second) << setting.key; });
  });
}

TEST(Settings, OptionsAreNamedOnce) {
  std::set<std::string> options;
  const auto collect = [&]<class T>(T) {
    forEachSetting<T>([&](const auto& setting) {
      if (!setting.option) return;
      EXPECT_TRUE(options.insert(setting.option).second) << setting.option;
    });
  };
  collect(Method{});
  forEachMethod([&]<class M>() { collect(M{}); });
  collect(Cutaway{});
  collect(ContextLayer{});
  collect(Shading{});
  collect(FocusAppearance{});
  collect(ValueFocus{});
  collect(ContextFunction{});
  collect(Look{});
}

}  // namespace
}  // namespace fenestra::tests::settingsTest
