#pragma once

#include <cstddef>
#include <vector>

namespace dda {

/// Bytes from one rank to another. Messages of one pair of ranks arrive in the order in which they were sent.
class Transport {
 public:
  virtual ~Transport() = default;
  virtual std::size_t size() const = 0;
  virtual std::size_t rank() const = 0;
  /// Returns when the bytes may be forgotten.
  virtual void send(std::size_t to, const std::vector<std::byte>& bytes) = 0;
  /// Waits; a rank that has nothing to do leaves its processor to others.
  virtual std::vector<std::byte> receive(std::size_t from) = 0;
};

}  // namespace dda
