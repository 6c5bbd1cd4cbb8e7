#pragma once

#include <cstddef>

// CHOLMOD's arrays and counts in the types that they have.
namespace dda {

inline int* integers(void* p) { return static_cast<int*>(p); }
inline double* reals(void* p) { return static_cast<double*>(p); }
inline std::size_t count(int i) { return static_cast<std::size_t>(i); }

}  // namespace dda
