/// Parameter structs of a type chosen at run time: their members as a list, by name.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// A member by address. Members of nested structs are inlined; a list of structs is a list of tables.
struct field {
  /// Type of the value.
  enum class kind {
    numbers,  ///< One, or those of a vector, array or matrix.
    whole,    ///< A whole number.
    truth,    ///< A bool.
    choice,   ///< One of about.choices, as its number.
    text,     ///< A std::string.
    points,   ///< A list of points, as many as are given.
    tables,   ///< A list of structs.
  };
  member_description about;              ///< Name, unit, range.
  kind type = kind::numbers;             ///< Type.
  void* at = nullptr;                    ///< The value, or the first of the numbers.
  int rows = 1;                          ///< Of numbers, column by column; or of whole numbers.
  int columns = 1;                       ///< Likewise.
  int (*get)(const void* at) = nullptr;  ///< Reads a whole number, truth or choice.
  bool (*set)(void* at,
              int value) = nullptr;  ///< Writes it; false for a negative number of an unsigned type.
  std::size_t stride = 0;            ///< Between the whole numbers of an array [bytes].
  std::vector<std::vector<field>> tables = {};  ///< One per struct of the list.
  /// Resizes a list of structs and returns their tables; nullptr for a fixed length.
  std::vector<std::vector<field>> (*resize_tables)(void* at, std::size_t count) = nullptr;
  /// Resizes a list of points of `rows` numbers each, stored contiguously; returns the first number.
  double* (*resize)(void* at, std::size_t points) = nullptr;
  /// Number of points of such a list.
  std::size_t (*size)(const void* at) = nullptr;

  /// `count` values of type whole number, truth or choice.
  template <class V>
  static field of(const member_description& about, V* first, int count) {
    field f{about,
            std::is_enum_v<V>         ? kind::choice
            : std::is_same_v<V, bool> ? kind::truth
                                      : kind::whole,
            first};
    f.rows = count;
    f.stride = sizeof(V);
    f.get = [](const void* from) { return static_cast<int>(*static_cast<const V*>(from)); };
    f.set = [](void* to, int x) {
      *static_cast<V*>(to) = static_cast<V>(x);
      return x >= 0 || !std::is_unsigned_v<V>;
    };
    return f;
  }

  int count() const { return rows * columns; }                          ///< Number of numbers.
  double* numbers() const { return static_cast<double*>(at); }          ///< The numbers.
  std::string& text() const { return *static_cast<std::string*>(at); }  ///< The text.
};

/// Fields of a parameter struct in the order of its table.
using field_list = std::vector<field>;

/// Adds the members of a struct, which must outlive the list.
template <Parameters P>
void add_fields(field_list& all, P& table);

/// Fields of each struct of a list, which must outlive them.
template <class List>
std::vector<field_list> tables_of(List& list) {
  std::vector<field_list> all;
  for (auto& one : list) add_fields(all.emplace_back(), one);
  return all;
}

template <Parameters P>
void add_fields(field_list& all, P& table) {
  for_each_member(table, [&](const member_description& about, auto& value) {
    using V = std::remove_cvref_t<decltype(value)>;
    using kind = field::kind;
    if constexpr (Parameters<V>) {
      add_fields(all, value);
    } else if constexpr (requires { requires Parameters<typename V::value_type>; }) {
      field& f = all.emplace_back(field{about, kind::tables, &value});
      f.tables = tables_of(value);
      if constexpr (requires { value.resize(1); })
        f.resize_tables = [](void* at, std::size_t count) {
          static_cast<V*>(at)->resize(count);
          return tables_of(*static_cast<V*>(at));
        };
    } else if constexpr (std::is_same_v<V, std::string>) {
      all.push_back({about, kind::text, &value});
    } else if constexpr (requires { value.resize(1), value[0].data(); }) {
      field& f = all.emplace_back(field{about, kind::points, &value});
      f.rows = static_cast<int>(V::value_type::RowsAtCompileTime);
      f.resize = [](void* at, std::size_t points) {
        static_cast<V*>(at)->resize(points);
        return static_cast<V*>(at)->data()->data();
      };
      f.size = [](const void* at) { return static_cast<const V*>(at)->size(); };
    } else if constexpr (std::is_enum_v<V> || std::is_integral_v<V>) {
      all.push_back(field::of(about, &value, 1));
    } else if constexpr (requires { requires std::is_same_v<typename V::value_type, int>; }) {
      all.push_back(field::of(about, value.data(), static_cast<int>(value.size())));
    } else if constexpr (std::is_same_v<V, double>) {
      all.push_back({about, kind::numbers, &value});
    } else {
      static_assert(std::is_same_v<std::remove_cvref_t<decltype(*value.data())>, double>);
      field& f = all.emplace_back(field{about, kind::numbers, value.data(), static_cast<int>(value.size())});
      if constexpr (requires { value.cols(); }) {
        f.rows = static_cast<int>(value.rows());
        f.columns = static_cast<int>(value.cols());
      }
    }
  });
}

/// No parameters.
struct no_parameters {
  static constexpr auto members() { return member_table(); }
};

/// Holds a parameter struct by value.
class any_parameters {
 public:
  /// No parameters.
  any_parameters() : any_parameters(no_parameters()) {}
  /// Holds these parameters.
  template <Parameters P>
  explicit any_parameters(P p) : held_(std::make_unique<model<P>>(std::move(p))) {}
  /// A copy.
  any_parameters(const any_parameters& other) : held_(other.held_->copy()) {}
  /// Moves.
  any_parameters(any_parameters&&) noexcept = default;
  /// A copy.
  any_parameters& operator=(const any_parameters& other) {
    held_ = other.held_->copy();
    return *this;
  }
  /// Moves.
  any_parameters& operator=(any_parameters&&) noexcept = default;
  ~any_parameters() = default;

  /// By address, valid until an assignment to this object.
  field_list fields() { return held_->fields(); }
  /// Error text of validate(), empty if there is none.
  std::string error() const { return held_->error(); }
  /// One line per unusual value, by remarks().
  std::string remarks(const std::string& part = "") const { return held_->remarks(part); }
  /// Calls f(name, error) for each implausible value, by passive_haptics::for_each_suspicious().
  void for_each_suspicious(const std::function<void(const char*, const std::string&)>& f) const {
    held_->for_each_suspicious(f);
  }

  /// The struct. Throws std::logic_error for another type.
  template <class P>
  const P& as() const {
    const void* found = held_->as(typeid(P));
    if (found == nullptr)
      throw std::logic_error(
          "passive_haptics: the parameters have a different type: expected that of as<P>()");
    return *static_cast<const P*>(found);
  }

 private:
  struct any_model {
    virtual ~any_model() = default;
    virtual std::unique_ptr<any_model> copy() const = 0;
    virtual field_list fields() = 0;
    virtual std::string error() const = 0;
    virtual std::string remarks(const std::string& part) const = 0;
    virtual void for_each_suspicious(const std::function<void(const char*, const std::string&)>& f) const = 0;
    virtual const void* as(const std::type_info& type) const = 0;
  };
  template <class P>
  struct model final : any_model {
    explicit model(P p) : value(std::move(p)) {}
    std::unique_ptr<any_model> copy() const override { return std::make_unique<model>(value); }
    field_list fields() override {
      field_list all;
      add_fields(all, value);
      return all;
    }
    std::string error() const override { return validate(value); }
    std::string remarks(const std::string& part) const override {
      return passive_haptics::remarks(value, part);
    }
    void for_each_suspicious(const std::function<void(const char*, const std::string&)>& f) const override {
      passive_haptics::for_each_suspicious(
          value, [&](const member_description& m, const std::string& error) { f(m.name, error); });
    }
    const void* as(const std::type_info& type) const override { return type == typeid(P) ? &value : nullptr; }
    P value;
  };

  std::unique_ptr<any_model> held_;
};

}  // namespace passive_haptics::runtime
