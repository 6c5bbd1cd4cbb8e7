#include <map>
#include <sstream>

#include "framework/files/run/base64.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {
namespace {

/// Gathers what a page says of a log, line by line.
class LogDigest {
 public:
  explicit LogDigest(std::size_t most_events) : most_events_(most_events) {}

  void take(const Json& line) {
    const std::string event = line.value("event", ""), time = line.value("time", "");
    if (first_time_.empty()) first_time_ = time;
    last_time_ = time;
    if (event == "started" || event == "resumed") is_open_ = true;
    if (event == "ended") is_open_ = false;
    if (event == "step") {
      // A step that was taken again after a resume counts once.
      steps_[line.value("step", 0)] = {line.value("residual", 0.0), line.value("jump_energy", 0.0),
                                       line.value("landed", Json())};
      return;
    }
    ++counts_[event];
    if (events_.size() < most_events_)
      events_.push_back(line);
    else
      ++left_out_;
  }

  Json result() const {
    return {{"started", first_time_}, {"last", last_time_},    {"is_open", is_open_}, {"counts", counts_},
            {"events", events_},      {"left_out", left_out_}, {"steps", steps()}};
  }

 private:
  struct Step {
    double residual = 0, jump_energy = 0;
    Json landed;
  };

  Json steps() const {
    std::vector<double> number, residual, jump_energy;
    Json landed = Json::object();
    for (const auto& [number_of_step, step] : steps_) {
      number.push_back(number_of_step);
      residual.push_back(step.residual);
      jump_energy.push_back(step.jump_energy);
      if (!step.landed.is_null()) landed[std::to_string(number_of_step)] = step.landed;
    }
    const auto packed = [](const std::vector<double>& v) { return base64_of(std::span<const double>(v)); };
    return {{"step", packed(number)},
            {"residual", packed(residual)},
            {"jump_energy", packed(jump_energy)},
            {"landed", landed}};
  }

  std::size_t most_events_, left_out_ = 0;
  std::string first_time_, last_time_;
  bool is_open_ = false;
  std::map<std::string, int> counts_;
  std::map<int, Step> steps_;
  Json events_ = Json::array();
};

}  // namespace

Json data_of_log(const std::filesystem::path& file, const Limits& limits) {
  LogDigest digest(limits.events);
  std::istringstream lines(read_whole(file));
  for (std::string text; std::getline(lines, text);) {
    const Json line = Json::parse(text, nullptr, false);
    try {
      if (line.is_object()) digest.take(line);
    } catch (const Json::type_error&) {
      // A damaged line, with a text where a number should be, says nothing; the last one of a killed run is no object.
    }
  }
  return digest.result();
}

}  // namespace dda::report
