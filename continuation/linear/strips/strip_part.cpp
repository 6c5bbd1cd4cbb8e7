#include "continuation/linear/strips/strip_part.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// One 6 × 6 block on or below the diagonal.
struct Stored {
  std::size_t row, column;
  double values[block_unknowns * block_unknowns];
};

/// With the number of its last blocks that are a border.
std::pair<BlockMatrix, std::size_t> take_matrix(Message& from) {
  const auto rows = from.take<std::size_t>(), border = from.take<std::size_t>();
  const auto stored = from.take_all<Stored>();
  std::vector<std::pair<BlockId, BlockId>> pairs;
  for (const Stored& block : stored) pairs.emplace_back(BlockId{block.row}, BlockId{block.column});
  BlockMatrix out(rows, std::move(pairs));
  for (const Stored& block : stored) {
    const Mat6 values = Eigen::Map<const Mat6>(block.values);
    out.add(BlockId{block.row}, BlockId{block.column}, values);
    if (block.row != block.column) out.add(BlockId{block.column}, BlockId{block.row}, values.transpose());
  }
  return {std::move(out), border};
}

/// Of a half solution, as it travels.
struct PlainEntry {
  std::size_t block;
  Eigen::Index pair;
  double rows[2 * block_unknowns];
};

std::vector<HalfSolver::Entry> take_entries(Message& from) {
  std::vector<HalfSolver::Entry> out;
  for (const PlainEntry& entry : from.take_all<PlainEntry>())
    out.push_back({BlockId{entry.block}, Eigen::Map<const Mat62>(entry.rows), entry.pair});
  return out;
}

void put_numbers(const Eigen::MatrixXd& values, Message& to) {
  to.put_all<double>({values.data(), static_cast<std::size_t>(values.size())});
}

double most_memory_held() {
  constexpr double bytes_per_kib = 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return bytes_per_kib * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

void put_matrix(const BlockMatrix& a, std::span<const std::size_t> blocks, std::size_t border, Message& to) {
  std::vector<std::size_t> here(a.num_rows(), none);
  for (std::size_t i = 0; i < blocks.size(); ++i) here[blocks[i]] = i;
  std::vector<Stored> stored;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t s = a.row_start()[blocks[i]]; s < a.row_start()[blocks[i] + 1]; ++s) {
      const std::size_t j = here[a.columns()[s]];
      if (j > i) continue;
      stored.push_back({i, j, {}});
      Eigen::Map<Mat6>(stored.back().values) = a.value(s);
    }
  to.put(blocks.size());
  to.put(border);
  to.put_all<Stored>(stored);
}

void put_entries(std::span<const HalfSolver::Entry> entries, Message& to) {
  std::vector<PlainEntry> out;
  for (const HalfSolver::Entry& entry : entries) {
    out.push_back({entry.block.value(), entry.pair, {}});
    Eigen::Map<Mat62>(out.back().rows) = entry.rows;
  }
  to.put_all<PlainEntry>(out);
}

void StripPart::count(Message& request, Message& reply) {
  const auto [a, border] = take_matrix(request);
  reply.put(matrix_.factor_bytes(a, border));
  reply.put(matrix_.factor_flops());
}

void StripPart::factor(Message& request, Message& reply) {
  set_num_threads(request.take<int>());
  const auto [a, border] = take_matrix(request);
  request = {};
  groups_.clear();
  place_.clear();
  num_rows_ = block_unknowns * a.num_rows();
  const bool is_definite = matrix_.factor(a, border);
  reply.put(is_definite);
  if (is_definite)
    reply.put_all<double>(matrix_.border_update());
  else
    matrix_.forget();
  reply.put(matrix_.factor_flops());
}

void StripPart::begin(Message& request, Message& reply) {
  const int columns = request.take<int>();
  const auto b = request.take_all<double>();
  const std::size_t inner = num_inner_rows(), border = num_rows_ - inner;
  begun_ = with_border(b);
  matrix_.begin(begun_, columns);
  std::vector<double> rest;
  for (std::size_t at = inner; at < begun_.size(); at += num_rows_)
    rest.insert(rest.end(), begun_.begin() + std::ptrdiff_t(at),
                begun_.begin() + std::ptrdiff_t(at + border));
  reply.put_all<double>(rest);
}

/// Zero there.
std::vector<double> StripPart::with_border(std::span<const double> inner) const {
  const std::size_t rows = num_inner_rows();
  std::vector<double> out(inner.size() / rows * num_rows_, 0.0);
  for (std::size_t c = 0; c * rows < inner.size(); ++c)
    std::copy_n(inner.data() + c * rows, rows, out.data() + c * num_rows_);
  return out;
}

void StripPart::finish(Message& request, Message& reply) {
  std::vector<double> sums = with_border(request.take_all<double>());
  finish(sums, request.take_all<double>(), reply);
}

void StripPart::complete(Message& request, Message& reply) {
  finish(begun_, request.take_all<double>(), reply);
  begun_ = {};
}

void StripPart::finish(std::span<double> sums, const std::vector<double>& border, Message& reply) {
  const std::size_t inner = num_inner_rows(), rows = num_rows_ - inner;
  for (std::size_t c = 0; c * num_rows_ < sums.size(); ++c)
    std::copy_n(border.begin() + std::ptrdiff_t(c * rows), rows,
                sums.begin() + std::ptrdiff_t(c * num_rows_ + inner));
  matrix_.complete(sums, static_cast<int>(sums.size() / num_rows_));
  std::vector<double> out;
  out.reserve(sums.size());
  for (std::size_t at = 0; at < sums.size(); at += num_rows_)
    out.insert(out.end(), sums.begin() + std::ptrdiff_t(at), sums.begin() + std::ptrdiff_t(at + inner));
  reply.put_all<double>(out);
}

/// Of each group what is left for the border; then its products with all groups up to it, group by group.
void StripPart::add(Message& request, Message& reply) {
  const auto new_groups = request.take<std::size_t>();
  const std::size_t first = groups_.size();
  std::vector<std::vector<HalfSolver::Entry>> entries;
  for (std::size_t i = 0; i < new_groups; ++i) {
    groups_.push_back({request.take<std::size_t>(), {}});
    place_.resize(std::max(place_.size(), groups_.back().name + 1), none);
    place_[groups_.back().name] = groups_.size() - 1;
    entries.push_back(take_entries(request));
  }
  std::vector<Eigen::MatrixXd> rests(new_groups);
  parallel_for(new_groups, 1,
               [&](std::size_t i) { groups_[first + i].y = matrix_.half_solve(entries[i], rests[i]); });
  for (const Eigen::MatrixXd& rest : rests) put_numbers(rest, reply);
  if (!request.take<bool>()) return;
  std::vector<std::vector<Eigen::MatrixXd>> products(new_groups);
  parallel_for(new_groups, 1, [&](std::size_t i) {
    for (std::size_t left = 0; left <= first + i; ++left)
      products[i].push_back(matrix_.product(groups_[left].y, groups_[first + i].y));
  });
  for (const auto& of_group : products)
    for (const Eigen::MatrixXd& product : of_group) put_numbers(product, reply);
}

void StripPart::product(Message& request, Message& reply) {
  const auto left = request.take<std::size_t>(), right = request.take<std::size_t>();
  put_numbers(matrix_.product(half_of(left), half_of(right)), reply);
}

void StripPart::multiple(Message& request, Message& reply) {
  const auto name = request.take<std::size_t>();
  const auto column = request.take<Eigen::Index>();
  const auto numbers = request.take_all<double>();
  std::vector<double> sum(num_rows_, 0.0);
  matrix_.add(half_of(name), column, Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers)),
              sum);
  reply.put_all<double>(std::span(sum).first(num_inner_rows()));
}

void StripPart::subtract(Message& request, Message& reply) {
  std::vector<double> sums;
  const auto columns = request.take<std::size_t>();
  for (std::size_t c = 0; c < columns; ++c) {
    sums.resize(sums.size() + num_rows_, 0.0);
    const std::span<double> sum = std::span(sums).last(num_rows_);
    for (auto runs = request.take<std::size_t>(); runs > 0; --runs) {
      const auto name = request.take<std::size_t>();
      const auto column = request.take<Eigen::Index>();
      const auto shares = request.take_all<double>();
      matrix_.add(half_of(name), column, Eigen::Map<const Eigen::VectorXd>(shares.data(), std::ssize(shares)),
                  sum);
    }
  }
  finish(sums, request.take_all<double>(), reply);
}

void StripPart::along(Message& request, Message& reply) {
  Eigen::MatrixXd rest;
  const HalfSolution y = matrix_.half_solve(take_entries(request), rest);
  put_numbers(rest.leftCols(1), reply);
  std::vector<Eigen::VectorXd> products(groups_.size());
  constexpr std::size_t at_once = 8;
  parallel_for(groups_.size(), at_once,
               [&](std::size_t g) { products[g] = matrix_.product(groups_[g].y, y).col(0); });
  for (const Eigen::VectorXd& product : products) put_numbers(product, reply);
}

void StripPart::answer(Order order, Message& request, Message& reply) {
  switch (order) {
    case Order::count:
      return count(request, reply);
    case Order::factor:
      return factor(request, reply);
    case Order::begin:
      return begin(request, reply);
    case Order::complete:
      return complete(request, reply);
    case Order::add:
      return add(request, reply);
    case Order::product:
      return product(request, reply);
    case Order::multiple:
      return multiple(request, reply);
    case Order::finish:
      return finish(request, reply);
    case Order::subtract:
      return subtract(request, reply);
    case Order::along:
      return along(request, reply);
    case Order::forget:
      groups_.clear();
      place_.clear();
      return;
    case Order::drop:
    case Order::memory:
      return;  // not about a part
  }
}

std::vector<double> memory_by_rank(Ranks& ranks) {
  std::vector<double> out;
  const auto request = [](std::size_t) {
    Message order;
    order.put(Order::memory);
    return order;
  };
  ranks.exchange(request, [&](std::size_t, Message& reply) { out.push_back(reply.take<double>()); });
  return out;
}

Answer answer_by_parts() {
  return [parts = std::make_shared<std::map<int, StripPart>>()](Message& request) {
    const auto order = request.take<Order>();
    Message reply;
    if (order == Order::memory) {
      reply.put(most_memory_held());
      return reply;
    }
    const auto matrix = request.take<int>();
    if (order == Order::drop)
      parts->erase(matrix);
    else
      (*parts)[matrix].answer(order, request, reply);
    return reply;
  };
}

}  // namespace dda
