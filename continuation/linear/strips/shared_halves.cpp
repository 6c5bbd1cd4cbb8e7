// Half solutions one at a time.
#include <algorithm>
#include <optional>

#include "continuation/linear/strips/shared_matrix.hpp"

namespace dda {
namespace {

/// A half solution names its group and the place from which on it has rows between the strips, which are its values.
HalfSolution half_solution(std::size_t group, const BetweenColumns& between, Eigen::Index columns) {
  HalfSolution out{{static_cast<int>(group), static_cast<int>(between.first)}, {}, columns};
  for (const Eigen::MatrixXd& at : between.at)
    out.values.insert(out.values.end(), at.data(), at.data() + at.size());
  return out;
}

std::size_t group_of(const HalfSolution& y) { return static_cast<std::size_t>(y.parts.front()); }

}  // namespace

BetweenColumns SharedMatrix::between_of(const HalfSolution& y) const {
  BetweenColumns out = between_.zero(static_cast<std::size_t>(y.parts.back()), y.columns);
  const double* from = y.values.data();
  for (Eigen::MatrixXd& at : out.at) {
    std::copy_n(from, at.size(), at.data());
    from += at.size();
  }
  return out;
}

HalfSolution SharedMatrix::half_solve(std::span<const Entry> entries) const {
  if (entries.empty()) return {};
  const std::lock_guard lock(one_at_a_time_);
  const Entries all(entries.begin(), entries.end());
  const std::vector<BetweenColumns> between = add_groups(std::span(&all, 1), nullptr);
  return half_solution(columns_.size() - 1, between.front(), columns_.back());
}

Eigen::MatrixXd SharedMatrix::product(const HalfSolution& left, const HalfSolution& right) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(left.columns, right.columns);
  if (left.parts.empty() || right.parts.empty()) return out;
  const std::lock_guard lock(one_at_a_time_);
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (!holds(k, group_of(left)) || !holds(k, group_of(right))) return {};
        Message request = request_for(Order::product);
        request.put(group_of(left));
        request.put(group_of(right));
        return request;
      },
      [&](std::size_t, Message& reply) {
        const auto values = reply.take_all<double>();
        out += Eigen::Map<const Eigen::MatrixXd>(values.data(), out.rows(), out.cols());
      });
  Between::add_product(between_of(left), between_of(right), out);
  return out;
}

std::size_t SharedMatrix::first_row(std::size_t strip) const {
  std::size_t blocks = 0;
  for (std::size_t k = 0; k < strip; ++k) blocks += strips_.strips[k].size();
  return block_unknowns * blocks;
}

void SharedMatrix::add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
                       std::span<double> sum) const {
  if (y.parts.empty()) return;
  const std::lock_guard lock(one_at_a_time_);
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (!holds(k, group_of(y))) return {};
        Message request = request_for(Order::multiple);
        request.put(group_of(y));
        request.put(first);
        request.put_all<double>({s.data(), static_cast<std::size_t>(s.size())});
        return request;
      },
      [&](std::size_t k, Message& reply) {
        double* to = sum.data() + first_row(k);
        for (const double value : reply.take_all<double>()) *to++ += value;
      });
  const BetweenColumns between = between_of(y);
  std::size_t row = first_row(num_strips());
  for (std::size_t place = 0; place < between_.size(); row += between_.num_rows(place++))
    if (place >= between.first)
      Eigen::Map<Eigen::VectorXd>(sum.data() + row, between.at[place - between.first].rows()).noalias() +=
          between.at[place - between.first].middleCols(first, s.size()) * s;
}

void SharedMatrix::complete(std::span<double> sums, int columns) const {
  const std::lock_guard lock(one_at_a_time_);
  BetweenColumns between = between_.zero(0, columns);
  for (int c = 0; c < columns; ++c) {
    const double* from = sums.data() + static_cast<std::size_t>(c) * num_rows() + first_row(num_strips());
    for (Eigen::MatrixXd& at : between.at) {
      std::copy_n(from, at.rows(), at.col(c).data());
      from += at.rows();
    }
  }
  between_.complete(between);
  std::vector<double> out(sums.size());
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::finish);
        std::vector<double> of_strip;
        for (std::size_t start = first_row(k); start < sums.size(); start += num_rows()) {
          const auto values = sums.subspan(start, block_unknowns * strips_.strips[k].size());
          of_strip.insert(of_strip.end(), values.begin(), values.end());
        }
        request.put_all<double>(of_strip);
        request.put_all<double>(border_values(k, between));
        return request;
      },
      [&](std::size_t k, Message& reply) { scatter(k, reply.take_all<double>(), out); });
  scatter(between, out);
  std::ranges::copy(out, sums.begin());
}

}  // namespace dda
