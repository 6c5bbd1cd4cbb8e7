#include "studies/dda/record/path/small_extrema.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

bool is_extremum(const Json& event) {
  return event["kind"] == "limit_point" || event["kind"] == "turning_point";
}

double value_of(const Json& event, const std::string& quantity) {
  return (quantity == "load" ? event["load"] : event["gauges"][quantity]).get<double>();
}

/// The extrema of one quantity along the path, between its ends.
struct Course {
  std::string quantity;
  int stage = 0;                        ///< of a load, where several are followed
  std::vector<double> values;           ///< start, extrema, end
  std::vector<std::size_t> numbers{0};  ///< of the events; of the ends without meaning

  void remove(std::size_t from, std::size_t count) {
    const auto at = static_cast<std::ptrdiff_t>(from), end = static_cast<std::ptrdiff_t>(from + count);
    values.erase(values.begin() + at, values.begin() + end);
    numbers.erase(numbers.begin() + at, numbers.begin() + end);
  }
  bool is_end(std::size_t i) const { return i == 0 || i + 1 == values.size(); }
};

double largest_of(const std::vector<double>& values) {
  double out = 0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

/// Removes pairs, or one beside an end, from the smallest difference on, as long as it is below the depth.
void flatten(Course& course, double depth) {
  const double largest = largest_of(course.values);
  const auto stays = [&](std::size_t i) { return course.is_end(i) || std::abs(course.values[i]) == largest; };
  for (;;) {
    std::size_t best = course.values.size();
    double least = depth;
    for (std::size_t i = 0; i + 1 < course.values.size(); ++i) {
      const double difference = std::abs(course.values[i + 1] - course.values[i]);
      if (difference >= least || (stays(i) && stays(i + 1))) continue;
      least = difference;
      best = i;
    }
    if (best == course.values.size()) return;
    const std::size_t first = best + stays(best), last = best + 1 - stays(best + 1);
    course.remove(first, last + 1 - first);
  }
}

/// By quantity, loads by stage.
using Courses = std::map<std::pair<std::string, int>, Course>;

Courses courses_of(const Json& events) {
  Courses out;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!is_extremum(events[i])) continue;
    const auto quantity = events[i]["of"].get<std::string>();
    const int stage = quantity == "load" ? events[i].value("stage", 0) : 0;
    Course& course = out[{quantity, stage}];
    course.quantity = quantity;
    course.stage = stage;
    if (course.values.empty()) course.values.push_back(0);
    course.values.push_back(value_of(events[i], quantity));
    course.numbers.push_back(i);
  }
  return out;
}

/// What a quantity is at an end of the path.
double value_at(const Measurement& at, const std::string& quantity, const std::vector<Column>& names) {
  const auto found = std::ranges::find(names, quantity, &Column::name);
  const auto number = static_cast<std::size_t>(found - names.begin());
  return quantity == "load" || number >= at.values.size() ? at.load : at.values[number];
}

}  // namespace

ListedEvents listed_events(const Json& events, const Measurement& start, const Measurement& end,
                           const std::vector<Column>& names) {
  Courses courses = courses_of(events);
  double displacement = 0;  // of all gauges: one that hardly moves beside the others does not turn
  for (auto& [key, course] : courses) {
    const std::string& quantity = course.quantity;
    if (course.stage == 0) course.values.front() = value_at(start, quantity, names);
    course.values.push_back(course.stage == 0 ? value_at(end, quantity, names) : 0);
    course.numbers.push_back(0);
    if (quantity != "load") displacement = std::max(displacement, largest_of(course.values));
  }
  std::vector<bool> is_listed(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) is_listed[i] = !is_extremum(events[i]);
  Json small = {{"depth", listed_depth}};
  for (auto& [key, course] : courses) {
    const std::string& quantity = course.quantity;
    const std::size_t all = course.values.size();
    const std::vector<double> before_end(course.values.begin(), course.values.end() - 1);
    flatten(course, listed_depth * (quantity == "load" ? largest_of(before_end) : displacement));
    if (course.values.size() < all)
      small[quantity] = small.value(quantity, std::size_t{0}) + all - course.values.size();
    for (std::size_t i = 1; i + 1 < course.numbers.size(); ++i) is_listed[course.numbers[i]] = true;
  }
  ListedEvents out{Json::array(), small.size() > 1 ? small : Json()};
  for (std::size_t i = 0; i < events.size(); ++i)
    if (is_listed[i]) out.listed.push_back(events[i]);
  return out;
}

}  // namespace dda
