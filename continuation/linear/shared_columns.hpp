#pragma once

#include "continuation/linear/strips/shared_matrix.hpp"
#include "continuation/linear/update_columns.hpp"

namespace dda {

/// Columns for what the ranks of the run have factorised, as `update_columns` makes them where K has no border.
std::unique_ptr<UpdateColumns> shared_columns(const Equilibrium& equilibrium, const SharedMatrix& matrix,
                                              std::size_t batch);

}  // namespace dda
