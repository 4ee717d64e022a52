#pragma once
// Lists of types: what the rows of a table have in common use of, once each.

#include <type_traits>
#include <variant>

namespace leadscrew::nc {

template <class... Types>
struct TypeList {};

/// The types of all lists in order, without repeats.
template <class... Lists>
struct Joined;
template <class... Known>
struct Joined<TypeList<Known...>> {
  using Types = TypeList<Known...>;
  using Variant = std::variant<Known...>;
};
template <class... Known, class... Lists>
struct Joined<TypeList<Known...>, TypeList<>, Lists...> : Joined<TypeList<Known...>, Lists...> {};
template <class... Known, class Next, class... More, class... Lists>
struct Joined<TypeList<Known...>, TypeList<Next, More...>, Lists...>
    : Joined<std::conditional_t<(std::is_same_v<Known, Next> || ...), TypeList<Known...>, TypeList<Known..., Next>>,
             TypeList<More...>, Lists...> {};

}  // namespace leadscrew::nc
