#pragma once
// A way to open the view to a focus: one of the methods of Registry.h.
//
// The folder of a method has its parameters in a struct with: word, in files and on the command line; name and
// description, in the window; stages(), what it decides on; settingsOf<> of its parameters, if it has any. It may have:
// programs(), the parameters that decide on shaders, all others at their defaults; carves, where the opening is what
// the user's tools carve away.

#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "rendering/methods/Registry.h"
#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

template <class M>
concept MethodModule = std::is_aggregate_v<M> && std::equality_comparable<M> && requires(const M method) {
  { M::word } -> std::convertible_to<const char*>;
  { M::name } -> std::convertible_to<const char*>;
  { M::description } -> std::convertible_to<const char*>;
  { method.stages() } -> std::same_as<MethodStages>;
};

/// The place of a method in the list; the default is the first one.
enum class MethodKind : std::uint8_t {};

namespace detail {

template <class List>
struct MethodTypesOf;

template <MethodModule... M>
struct MethodTypesOf<MethodTypes<M...>> {
  using Chosen = std::variant<M...>;
  /// Each method's parameters, by its type.
  struct Each : M... {
    bool operator==(const Each&) const = default;
  };

  static constexpr auto words() {
    std::uint8_t next = 0;
    return std::array{Word<MethodKind>{static_cast<MethodKind>(next++), M::word, M::name, M::description}...};
  }
  template <class Wanted>
  static constexpr MethodKind kindOf() {
    std::uint8_t kind = 0, next = 0;
    ((std::same_as<Wanted, M> ? void(kind = next++) : void(++next)), ...);
    return static_cast<MethodKind>(kind);
  }
  static constexpr void forEach(auto&& use) { (use.template operator()<M>(), ...); }
  template <class Wanted>
  static constexpr bool has = (std::same_as<Wanted, M> || ...);
};

using AllMethods = MethodTypesOf<Methods>;

}  // namespace detail

/// A method of the list.
template <class M>
concept OneOfMethods = detail::AllMethods::has<M>;

template <OneOfMethods M>
inline constexpr MethodKind kindOf = detail::AllMethods::kindOf<M>();

constexpr auto wordsOf(MethodKind) { return detail::AllMethods::words(); }

/// Calls use.operator()<M>() for every method M of the list, in its order.
constexpr void forEachMethod(auto&& use) { detail::AllMethods::forEach(use); }

/// The parameters of one method: what a picture depends on.
using ChosenMethod = detail::AllMethods::Chosen;

/// The method that is chosen. Every other one keeps its parameters until it is chosen again; sessions keep them, too.
struct Method {
  MethodKind kind{};
  detail::AllMethods::Each parameters{};

  Method() = default;
  /// Chooses a method; all have their defaults.
  explicit Method(MethodKind which) : kind(which) {}
  /// Chooses a method; all others have their defaults.
  template <OneOfMethods M>
  Method(const M& chosen) : kind(kindOf<M>) {
    of<M>() = chosen;
  }

  template <OneOfMethods M>
  bool is() const {
    return kind == kindOf<M>;
  }
  /// The parameters of a method, chosen or not.
  template <OneOfMethods M>
  M& of() {
    return parameters;
  }
  template <OneOfMethods M>
  const M& of() const {
    return parameters;
  }
  ChosenMethod chosen() const;

  bool operator==(const Method&) const = default;
};

template <>
inline constexpr std::tuple settingsOf<Method>{Setting(
    &Method::kind,
    {.key = "kind", .option = "--method", .name = "Method", .description = "How the view is opened to the focus"})};

MethodStages stagesOf(const Method& method);

/// Whether the opening of a method is what the user's tools carve away.
bool carves(MethodKind kind);

}  // namespace fenestra
