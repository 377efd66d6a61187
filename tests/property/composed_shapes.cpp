// slow
#include <experiments/specimens.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/shape_properties.hpp>

#include "user_shapes.hpp"

#include <tuple>
#include <type_traits>

namespace ph = passive_haptics;
using namespace passive_haptics::testing;

template <class Shape, int Size = 2>
struct around_origin {
  using shape = Shape;
  static ph::point<shape::dimension> lower() { return ph::point<shape::dimension>::Constant(-Size); }
  static ph::point<shape::dimension> upper() { return ph::point<shape::dimension>::Constant(Size); }
};

struct nested_case : around_origin<ph::complement<ph::offset<ph::moving<ph::box<2>>>>> {
  static shape make() {
    ph::moving carried(ph::box<2>({0.1, -0.2}, {0.8, 0.4}));
    carried.set_motion({0.3, 0.1}, {1, 2});
    return shape(ph::offset(carried, 0.1));
  }
};

struct either_case : around_origin<ph::offset<custom::either<ph::disc, ph::rectangle>>> {
  static shape make() {
    return shape(custom::either(ph::disc({-0.7, 0}, 0.4), ph::rectangle({0.7, 0}, {0.2, 0.6})), 0.1);
  }
};

// The first of each type in the list of shapes, of about a metre, at a place in general position.
template <int D, class Specimen>
struct listed_case {
  using shape = std::invoke_result_t<decltype(Specimen::make), const experiments::place<D>&>;
  static shape make() {
    ph::point<D> normal = ph::point<D>::LinSpaced(1, 2), along = ph::point<D>::UnitX();
    normal.normalize();
    along = (along - normal * normal.x()).normalized();
    return Specimen(*found()).make(
        experiments::place<D>{ph::point<D>::Constant(0.1), normal, along, 0.5, 12});
  }
  static ph::point<D> lower() { return ph::point<D>::Constant(-1); }
  static ph::point<D> upper() { return ph::point<D>::Constant(1); }

 private:
  static const Specimen* found() { return &std::get<Specimen>(experiments::specimens); }
};

template <int D, class Specimen>
auto listed() {
  if constexpr (std::is_invocable_v<decltype(Specimen::make), const experiments::place<D>&>) {
    if constexpr (ph::Shape<typename listed_case<D, Specimen>::shape>)
      return std::tuple<listed_case<D, Specimen>>();
    else return std::tuple<>();
  } else {
    return std::tuple<>();
  }
}
template <class... Seen, class First, class... Rest>
auto with_distinct(std::tuple<Seen...>, std::tuple<First, Rest...>) {
  using now = std::conditional_t<(std::is_same_v<typename Seen::shape, typename First::shape> || ...),
                                 std::tuple<Seen...>, std::tuple<Seen..., First>>;
  if constexpr (sizeof...(Rest) == 0) return now();
  else return with_distinct(now(), std::tuple<Rest...>());
}
template <class List>
auto distinct(const List& all) {
  return with_distinct(std::tuple<>(), all);
}
template <class List>
struct as_types;
template <class... Case>
struct as_types<std::tuple<Case...>> {
  using type = ::testing::Types<Case...>;
};
template <class... Specimen>
auto cases_of(const std::tuple<Specimen...>&) {
  return distinct(std::tuple_cat(listed<2, Specimen>()..., listed<3, Specimen>()...));
}
using listed_cases = as_types<decltype(cases_of(experiments::specimens))>::type;
using other_cases = ::testing::Types<nested_case, either_case>;

INSTANTIATE_TYPED_TEST_SUITE_P(listed, shape_properties, listed_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(others, shape_properties, other_cases);
