#include "continuation/linear/displacements.hpp"

#include <algorithm>
#include <utility>

#include "models/kinematics/first_order.hpp"

namespace dda {
namespace {

/// Those of other displacements.
class AsOthers final : public Displacements::Completion {
 public:
  explicit AsOthers(Displacements others) : others_(std::move(others)) {}
  std::vector<double> all() const override { return others_.all(); }

 private:
  Displacements others_;
};

}  // namespace

Displacements::Displacements(std::vector<double> all)
    : content_(std::make_shared<Content>(Content{std::move(all)})) {}

Displacements::Displacements(std::vector<double> values, Nodes known, std::unique_ptr<Completion> completion,
                             std::optional<double> dead_work)
    : content_(std::make_shared<Content>(
          Content{std::move(values), std::move(known), std::move(completion), dead_work})) {}

/// What was known stays as it is: numbers must not hang on when the rest is asked for.
void Displacements::Content::complete() {
  if (!completion) return;
  const std::vector<double> all = completion->all();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(*known)[i / block_unknowns]) values[i] = all[i];
  completion.reset();
}

const std::vector<double>& Displacements::all() const {
  content_->complete();
  return content_->values;
}

bool Displacements::know(const Functional& gauge) const {
  return std::ranges::all_of(gauge.rows, [&](const auto& row) { return know(row.first.value()); });
}

Displacements Displacements::moved(double amount, std::span<const double> direction) const {
  std::vector<double> values = watched();
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += amount * direction[i];
  if (are_all_known()) return {std::move(values)};
  return {std::move(values), content_->known, std::make_unique<AsOthers>(*this)};
}

}  // namespace dda
