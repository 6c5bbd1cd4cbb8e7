#include "continuation/linear/column_groups.hpp"

namespace dda {

std::vector<std::span<const std::size_t>> neighbours(std::span<const std::size_t> points, std::size_t most) {
  std::vector<std::span<const std::size_t>> out;
  for (std::size_t begin = 0, end; begin < points.size(); begin = end) {
    for (end = begin + 1; end < points.size() && points[end] / most == points[begin] / most;) ++end;
    out.push_back(points.subspan(begin, end - begin));
  }
  return out;
}

std::vector<HalfSolver::Entry> entries_of(const Equilibrium& equilibrium,
                                          std::span<const std::size_t> points) {
  std::vector<HalfSolver::Entry> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    equilibrium.point(points[i]).for_each_part([&](BlockId part, const Mat26& rows) {
      out.push_back({part, rows.transpose(), static_cast<Eigen::Index>(i)});
    });
  return out;
}

}  // namespace dda
