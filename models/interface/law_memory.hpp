#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "framework/base/vec2.hpp"
#include "framework/deck/units.hpp"

namespace dda {

/// One thing that a law remembers of a point, as its record declares it.
struct Remembered {
  std::string name;
  Dimension dimension;
  int size = 1;  ///< numbers it has
};

/// The numbers in which an interface point keeps what its law alone knows how to read.
///
/// A law declares them once, in its own file, as a record of numbers, flags and vectors that are all zero at
/// a point which has never moved; models/interface/friction.cpp is an example:
///
///     struct Memory {
///       double slip = 0;     ///< s [L]
///       Vec2 opening{0, 0};  ///< q at the last accepted step [L]
///
///       template <class Self, class Visit>
///       static void visit(Self& self, Visit& visit) {
///         visit("slip", dimension::length, self.slip);
///         visit("opening", dimension::length, self.opening);
///       }
///     };
///
/// The record is read and replaced as a whole, `as<Memory>()` and `keep(memory)`, without allocation; a law around another one
/// keeps its own behind that one's numbers. The law's `memory()` returns `declared<Memory>()`, from which restart files and
/// contract tests follow.
class LawMemory {
 public:
  /// Numbers that a law may remember of a point.
  static constexpr std::size_t capacity = 10;

  template <class Memory>
  Memory as(std::size_t behind = 0) const {
    Memory out;
    Reader read{numbers_.data() + behind};
    Memory::visit(out, read);
    return out;
  }
  template <class Memory>
  void keep(const Memory& memory, std::size_t behind = 0) {
    Writer write{numbers_.data() + behind};
    Memory::visit(memory, write);
  }

  std::array<double, capacity>& numbers() { return numbers_; }
  const std::array<double, capacity>& numbers() const { return numbers_; }

 private:
  struct Reader {
    const double* at;
    void operator()(const char*, Dimension, double& value) { value = *at++; }
    void operator()(const char*, Dimension, int& value) { value = static_cast<int>(*at++); }
    void operator()(const char*, Dimension, Vec2& value) {
      value = {at[0], at[1]};
      at += 2;
    }
  };
  struct Writer {
    double* at;
    void operator()(const char*, Dimension, double value) { *at++ = value; }
    void operator()(const char*, Dimension, const Vec2& value) {
      at[0] = value.x();
      at[1] = value.y();
      at += 2;
    }
  };

  std::array<double, capacity> numbers_{};
};

/// What a law's record declares, in the order in which it is kept.
template <class Memory>
std::vector<Remembered> declared() {
  std::vector<Remembered> out;
  const Memory none;
  auto list = [&](const char* name, Dimension dimension, const auto& value) {
    constexpr bool is_vector = std::is_same_v<std::decay_t<decltype(value)>, Vec2>;
    out.push_back({name, dimension, is_vector ? 2 : 1});
  };
  Memory::visit(none, list);
  return out;
}

}  // namespace dda
