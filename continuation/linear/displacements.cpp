#include "continuation/linear/displacements.hpp"

#include <utility>

namespace dda {

const std::vector<double>& Displacements::Content::all() {
  if (values.empty() && sum) values = sum->all();
  return values;
}

void Displacements::Pending::settle() const {
  const auto content = content_.lock();
  if (!content) return;
  content->all();
  content->sum.reset();
}

Displacements::Displacements(std::shared_ptr<const Sum> sum)
    : content_(std::make_shared<Content>(Content{{}, std::move(sum)})) {
  content_->sum->note(Pending(*this));
}

double Displacements::value(const Functional& gauge, double load_factor) const {
  if (!sum()) return gauge.value(all(), load_factor);
  return gauge.per_load_factor * load_factor + gauge.constant +
         (gauge.rows.empty() ? 0 : sum()->product(gauge));
}

Displacements Displacements::combined(double a, double b, const Displacements& others) const {
  if (sum() && others.sum())
    if (auto both = sum()->combined(a, b, *others.sum())) return {std::move(both)};
  std::vector<double> values = all();
  const std::vector<double>& other = others.all();
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = a * values[i] + b * other[i];
  return {std::move(values)};
}

}  // namespace dda
