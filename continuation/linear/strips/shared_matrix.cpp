#include "continuation/linear/strips/shared_matrix.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

int next_name() {
  static int last = 0;
  return ++last;
}

std::vector<double> shares_of(std::size_t ranks) {
  const auto n = static_cast<double>(ranks);
  const double own = ranks == 1 ? 1 : 2 / (n * n);
  std::vector<double> out(ranks, (1 - own) / std::max(n - 1, 1.0));
  out.front() = own;
  return out;
}

/// The blocks of a strip, then those of its border.
std::vector<std::size_t> blocks_of(const Strips& strips, std::size_t strip, std::size_t& border) {
  std::vector<std::size_t> out = strips.strips[strip];
  const std::vector<std::size_t> others = strips.border_of(strip);
  border = others.size();
  out.insert(out.end(), others.begin(), others.end());
  return out;
}

}  // namespace

SharedMatrix::SharedMatrix(Ranks& ranks) : ranks_(ranks), name_(next_name()) {}

SharedMatrix::~SharedMatrix() {
  try {
    ranks_.exchange([&](std::size_t) { return request_for(Order::drop); }, [](std::size_t, Message&) {});
  } catch (...) {  // NOLINT: a rank that cannot forget has failed before, which was told
  }
}

Message SharedMatrix::request_for(Order order) const {
  Message out;
  out.put(order);
  out.put(name_);
  return out;
}

void SharedMatrix::divide(const BlockMatrix& a) {
  if (a.row_start() == pattern_rows_ && a.columns() == pattern_columns_) return;
  pattern_rows_ = a.row_start();
  pattern_columns_ = a.columns();
  strips_ = strips_of(a, shares_of(ranks_.size()));
  place_.resize(a.num_rows());
  for (std::size_t k = 0; k < num_strips(); ++k)
    for (std::size_t i = 0; i < strips_.strips[k].size(); ++i) place_[strips_.strips[k][i]] = {false, k, i};
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < strips_.between.size(); ++k) {
    for (std::size_t i = 0; i < strips_.between[k].size(); ++i) place_[strips_.between[k][i]] = {true, k, i};
    rows.push_back(block_unknowns * strips_.between[k].size());
  }
  between_.begin(rows);
}

std::vector<double> SharedMatrix::bytes_by_rank(const BlockMatrix& a) {
  divide(a);
  std::vector<double> out(ranks_.size(), 0.0);
  out.front() = between_.bytes();
  flops_ = between_.factor_flops();
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::count);
        std::size_t border = 0;
        const std::vector<std::size_t> blocks = blocks_of(strips_, k, border);
        put_matrix(a, blocks, border, request);
        return request;
      },
      [&](std::size_t k, Message& reply) {
        out[k] += reply.take<double>();
        flops_ += reply.take<double>();
      });
  return out;
}

double SharedMatrix::bytes_here(const BlockMatrix& a) {
  const std::vector<double> by_rank = bytes_by_rank(a);
  double out = 0;
  for (const std::size_t rank : ranks_.beside()) out += by_rank[rank];
  return out;
}

bool SharedMatrix::factor(const BlockMatrix& a) {
  divide(a);
  forget_groups();
  std::vector<std::size_t> rows;
  for (const auto& blocks : strips_.between) rows.push_back(block_unknowns * blocks.size());
  between_.begin(rows);
  for (std::size_t block = 0; block < place_.size(); ++block)
    for (std::size_t s = a.row_start()[block]; s < a.row_start()[block + 1]; ++s) {
      const Place &row = place_[block], &column = place_[a.columns()[s]];
      if (row.is_between && column.is_between && row.of == column.of)
        between_.diagonal(row.of).block<6, 6>(first_row_of(row.index), first_row_of(column.index)) +=
            a.value(s);
    }
  bool is_definite = true;
  flops_ = between_.factor_flops();
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::factor);
        request.put(num_threads());
        std::size_t border = 0;
        const std::vector<std::size_t> blocks = blocks_of(strips_, k, border);
        put_matrix(a, blocks, border, request);
        return request;
      },
      [&](std::size_t k, Message& reply) {
        if (reply.take<bool>())
          between_.add_strip(k, reply.take_all<double>());
        else
          is_definite = false;
        flops_ += reply.take<double>();
      });
  return is_definite && between_.factor();
}

void SharedMatrix::forget() {
  forget_groups();
  pattern_rows_.clear();
  between_.begin({});
  ranks_.exchange([&](std::size_t) { return request_for(Order::drop); }, [](std::size_t, Message&) {});
}

void SharedMatrix::solve(std::span<double> x, int columns) {
  const std::size_t n = num_rows();
  BetweenColumns between = between_.zero(0, columns);
  for (std::size_t block = 0; block < place_.size(); ++block)
    if (const Place& at = place_[block]; at.is_between)
      for (int c = 0; c < columns; ++c)
        between.at[at.of].col(c).segment<6>(first_row_of(at.index)) =
            Eigen::Map<const Vec6>(x.data() + static_cast<std::size_t>(c) * n + block_unknowns * block);
  const auto of_strip = [&](std::size_t k) {
    std::vector<double> out;
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
      for (const std::size_t block : strips_.strips[k]) {
        const auto values = x.subspan(c * n + block_unknowns * block, block_unknowns);
        out.insert(out.end(), values.begin(), values.end());
      }
    return out;
  };
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::begin);
        request.put(columns);
        request.put_all<double>(of_strip(k));
        return request;
      },
      [&](std::size_t k, Message& reply) { add_rest(k, reply.take_all<double>(), between); });
  between_.half_solve(between);
  between_.complete(between);
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::complete);
        request.put_all<double>(border_values(k, between));
        return request;
      },
      [&](std::size_t k, Message& reply) { scatter(k, reply.take_all<double>(), x); });
  scatter(between, x);
}

void SharedMatrix::add_rest(std::size_t strip, std::span<const double> rest, BetweenColumns& to) const {
  if (to.at.empty()) return;
  const double* from = rest.data();
  for (Eigen::Index c = 0; c < to.at.front().cols(); ++c)
    for (const std::size_t place : {strip - 1, strip})
      if (place < between_.size()) {
        auto here = to.at[place - to.first].col(c);
        here += Eigen::Map<const Eigen::VectorXd>(from, here.size());
        from += here.size();
      }
}

std::vector<double> SharedMatrix::border_values(std::size_t strip, const BetweenColumns& x) const {
  std::vector<double> out;
  for (Eigen::Index c = 0; !x.at.empty() && c < x.at.front().cols(); ++c)
    for (const std::size_t place : {strip - 1, strip})
      if (place < between_.size()) {
        const auto values = x.at[place].col(c);
        out.insert(out.end(), values.begin(), values.end());
      }
  return out;
}

void SharedMatrix::scatter(std::size_t strip, std::span<const double> x, std::span<double> to) const {
  const std::vector<std::size_t>& blocks = strips_.strips[strip];
  const double* from = x.data();
  for (std::size_t start = 0; start < to.size(); start += num_rows())
    for (const std::size_t block : blocks) {
      std::copy_n(from, block_unknowns, to.data() + start + block_unknowns * block);
      from += block_unknowns;
    }
}

void SharedMatrix::scatter(const BetweenColumns& x, std::span<double> to) const {
  for (std::size_t block = 0; block < place_.size(); ++block)
    if (const Place& at = place_[block]; at.is_between)
      for (std::size_t c = 0; c * num_rows() < to.size(); ++c)
        Eigen::Map<Vec6>(to.data() + c * num_rows() + block_unknowns * block) =
            x.at[at.of].col(static_cast<Eigen::Index>(c)).segment<6>(first_row_of(at.index));
}

}  // namespace dda
