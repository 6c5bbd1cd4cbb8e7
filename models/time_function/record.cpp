#include <algorithm>
#include <cmath>
#include <filesystem>

#include "framework/files/curve_table.hpp"
#include "models/time_function/time_function.hpp"

namespace dda {
namespace {

struct RecordedParameters {
  std::filesystem::path file;
  std::string time, acceleration;
  double factor = 1;
  Position where;
};

/// The displacement of a recorded acceleration, which is straight between its entries: integrated twice, exactly, from
/// rest. It stays where it is behind the last entry.
class Recorded final : public TimeFunction {
 public:
  explicit Recorded(const RecordedParameters& p) {
    const CsvTable table = read_csv(p.file);
    times_ = table.numbers(p.time);
    rates_ = table.numbers(p.acceleration);
    if (times_.size() < 2 || times_.front() != 0 ||
        !std::ranges::is_sorted(times_, std::ranges::less_equal()))
      throw InputError(p.where, "'" + p.file.string() + "': the times of a record begin with 0 and grow");
    require_finite(p);
    for (double& a : rates_) a *= p.factor;
    velocities_ = places_ = {0};
    for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
      const double end = times_[i + 1];
      velocities_.push_back(velocities_[i] + (end - times_[i]) * (rates_[i] + rates_[i + 1]) / 2);
      places_.push_back(within(i, end));
    }
  }
  double at(double time) const override {
    const auto next = std::ranges::upper_bound(times_, time);
    return next == times_.end() ? places_.back()
                                : within(static_cast<std::size_t>(next - times_.begin()) - 1, time);
  }

 private:
  void require_finite(const RecordedParameters& p) const {
    for (const auto& [name, values] : {std::pair{&p.time, &times_}, std::pair{&p.acceleration, &rates_}}) {
      const auto found = std::ranges::find_if(*values, [](double value) { return !std::isfinite(value); });
      if (found == values->end()) continue;
      const int line = static_cast<int>(found - values->begin()) + 2;  // behind the names
      throw InputError({p.file.string(), line, 1}, "the " + *name + " of a record is no finite number");
    }
  }

  double within(std::size_t i, double time) const {
    const double t = time - times_[i], slope = (rates_[i + 1] - rates_[i]) / (times_[i + 1] - times_[i]);
    return places_[i] + t * (velocities_[i] + t * (rates_[i] / 2 + t * slope / 6));
  }

  std::vector<double> times_, rates_, velocities_, places_;
};

Schema<RecordedParameters> schema() {
  using P = RecordedParameters;
  return Schema<P>(
             "A recorded acceleration, such as that of an earthquake, from a CSV file; integrated from rest. "
             "Behind its last entry all stands: one that ends with a velocity is to be corrected first.")
      .file("file", &P::file, {.text = "The CSV file; its first line names the columns."})
      .text("time", &P::time, {.fallback = "time", .text = "Column of the times, the first 0 [s]."})
      .text("acceleration", &P::acceleration,
            {.fallback = "acceleration", .text = "Column of the accelerations."})
      .number("factor", &P::factor,
              {.fallback = 1,
               .text = "By which accelerations are multiplied, such as 9.81 for a record in g and metres."});
}

}  // namespace

DDA_REGISTER(time_functions(), "record", schema(), make_of<Recorded>);

}  // namespace dda
