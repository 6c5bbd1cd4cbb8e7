// Half solutions that the ranks keep.
#include <algorithm>
#include <utility>

#include "continuation/linear/strips/shared_matrix.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

Eigen::Index columns_of(const SharedMatrix::Entries& entries) {
  Eigen::Index out = 0;
  for (const HalfSolver::Entry& entry : entries) out = std::max(out, 2 * entry.pair + 2);
  return out;
}

/// Keeps the last of so many columns where others alone have entries.
HalfSolver::Entry nothing_at(BlockId block, Eigen::Index columns) {
  return {block, Mat62::Zero(), columns / 2 - 1};
}

}  // namespace

/// The first place between strips where a half solution is not zero.
std::size_t SharedMatrix::first_beside(const Entries& entries) const {
  std::size_t out = between_.size();
  for (const HalfSolver::Entry& entry : entries) {
    const Place& at = place_[entry.block.value()];
    out = std::min(out, at.is_between || at.of == 0 ? at.of : at.of - 1);
  }
  return out;
}

SharedMatrix::Entries SharedMatrix::entries_in(const Entries& entries, std::size_t strip) const {
  Entries out;
  for (const HalfSolver::Entry& entry : entries)
    if (const Place& at = place_[entry.block.value()]; !at.is_between && at.of == strip)
      out.push_back({BlockId{at.index}, entry.rows, entry.pair});
  return out;
}

void SharedMatrix::add_entries(const Entries& entries, BetweenColumns& to) const {
  for (const HalfSolver::Entry& entry : entries)
    if (const Place& at = place_[entry.block.value()]; at.is_between)
      to.at[at.of - to.first].block<6, 2>(first_row_of(at.index), 2 * entry.pair) += entry.rows;
}

std::vector<BetweenColumns> SharedMatrix::add_groups(std::span<const Entries> groups,
                                                     const TakeProduct* take) const {
  const std::size_t first = columns_.size();
  std::vector<BetweenColumns> out;
  for (const Entries& entries : groups) {
    columns_.push_back(columns_of(entries));
    out.push_back(between_.zero(first_beside(entries), columns_.back()));
    add_entries(entries, out.back());
  }
  held_.resize(num_strips());
  std::vector<std::size_t> held_before;
  for (const auto& held : held_) held_before.push_back(held.size());
  const auto request = [&](std::size_t k) -> std::optional<Message> {
    if (k >= num_strips()) return {};
    Message content;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      Entries here = entries_in(groups[i], k);
      if (here.empty()) continue;
      here.push_back(nothing_at(here.front().block, columns_[first + i]));
      held_[k].push_back(first + i);
      content.put(first + i);
      put_entries(here, content);
    }
    if (held_[k].size() == held_before[k]) return {};
    Message all = request_for(Order::add);
    all.put(held_[k].size() - held_before[k]);
    all.append(content);
    all.put(take != nullptr);
    return all;
  };
  ranks_.exchange(request, [&](std::size_t k, Message& reply) {
    const auto& held = held_[k];
    for (std::size_t i = held_before[k]; i < held.size(); ++i)
      add_rest(k, reply.take_all<double>(), out[held[i] - first]);
    for (std::size_t i = held_before[k]; take && i < held.size(); ++i)
      for (std::size_t left = 0; left <= i; ++left) (*take)(held[left], held[i], reply.take_all<double>());
  });
  parallel_for(out.size(), 1, [&](std::size_t i) { between_.half_solve(out[i]); });
  return out;
}

bool SharedMatrix::holds(std::size_t strip, std::size_t group) const {
  return strip < held_.size() && std::ranges::binary_search(held_[strip], group);
}

void SharedMatrix::forget_groups() const {
  if (columns_.empty()) return;
  columns_.clear();
  held_.clear();
  ranks_.exchange([&](std::size_t) { return request_for(Order::forget); }, [](std::size_t, Message&) {});
}

std::vector<double> SharedMatrix::complete(std::span<const std::vector<Multiple>> sums,
                                           BetweenColumns between) const {
  between_.complete(between);
  std::vector<double> out(sums.size() * num_rows());
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        if (k >= num_strips()) return {};
        Message request = request_for(Order::subtract);
        request.put(sums.size());
        for (const std::vector<Multiple>& sum : sums) {
          std::vector<const Multiple*> here;
          for (const Multiple& multiple : sum)
            if (holds(k, multiple.group)) here.push_back(&multiple);
          request.put(here.size());
          for (const Multiple* multiple : here) {
            request.put(multiple->group);
            request.put(multiple->column);
            request.put_all<double>(
                {multiple->factors.data(), static_cast<std::size_t>(multiple->factors.size())});
          }
        }
        request.put_all<double>(border_values(k, between));
        return request;
      },
      [&](std::size_t k, Message& reply) { scatter(k, reply.take_all<double>(), out); });
  scatter(between, out);
  return out;
}

BetweenColumns SharedMatrix::along(const Entries& entries, const TakeProduct& take) const {
  BetweenColumns out = between_.zero(first_beside(entries), columns_of(entries));
  add_entries(entries, out);
  for (Eigen::MatrixXd& values : out.at) values.conservativeResize(Eigen::NoChange, 1);
  ranks_.exchange(
      [&](std::size_t k) -> std::optional<Message> {
        const Entries here = k < num_strips() ? entries_in(entries, k) : Entries{};
        if (here.empty()) return {};
        Message request = request_for(Order::along);
        put_entries(here, request);
        return request;
      },
      [&](std::size_t k, Message& reply) {
        add_rest(k, reply.take_all<double>(), out);
        if (k >= held_.size()) return;
        for (const std::size_t group : held_[k]) take(group, group, reply.take_all<double>());
      });
  between_.half_solve(out);
  return out;
}

}  // namespace dda
