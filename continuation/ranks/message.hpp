#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace dda {

/// Numbers on their way from one process to another of the same program on the same kind of machine: taken out in the
/// order in which they were put in, by the types they had.
class Message {
 public:
  Message() = default;
  explicit Message(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
  const std::vector<std::byte>& bytes() const { return bytes_; }

  template <class T>
  void put(const T& value) {
    put_bytes(std::as_bytes(std::span(&value, 1)));
    static_assert(std::is_trivially_copyable_v<T>);
  }
  /// Numbers, with how many there are.
  template <class T>
  void put_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(values.size());
    put_bytes(std::as_bytes(values));
  }

  void append(const Message& other) { put_bytes(other.bytes_); }

  template <class T>
  T take() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    take_bytes(&value, sizeof(T));
    return value;
  }
  template <class T>
  std::vector<T> take_all() {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto count = take<std::size_t>();
    if (count > (bytes_.size() - at_) / sizeof(T)) throw std::logic_error("a message is too short");
    std::vector<T> values(count);
    take_bytes(values.data(), count * sizeof(T));
    return values;
  }

 private:
  void put_bytes(std::span<const std::byte> bytes) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + bytes.size());
    if (!bytes.empty()) std::memcpy(bytes_.data() + end, bytes.data(), bytes.size());
  }
  void take_bytes(void* to, std::size_t count) {
    if (count > bytes_.size() - at_) throw std::logic_error("a message is too short");
    if (count > 0) std::memcpy(to, bytes_.data() + at_, count);
    at_ += count;
  }

  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;  ///< of what is taken next
};

}  // namespace dda
