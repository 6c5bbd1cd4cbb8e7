#include "studies/dda/run/motion/motion_restart.hpp"

#include <array>

#include "framework/base/errors.hpp"
#include "framework/files/run/record.hpp"

namespace dda {
namespace {

/// The numbers of a motion, one by one.
struct Scalars {
  MotionRestart& at;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    auto& m = self.at.motion;
    visit("steps", self.at.steps);
    visit("frames", self.at.frames);
    visit("stored", self.at.stored);
    visit("time", m.time);
    visit("most_kinetic", m.most_kinetic);
    visit("overdrawn", m.overdrawn);
    visit("step", m.dt.now);
    visit("step_before", m.dt.before);
    visit("begins", m.dt.begins);
    visit("iterations", m.iterations);
    visit("rejected", m.rejected);
    visit("easy", m.easy);
    visit("still", m.still);
    visit("is_released", m.is_released);
    visit("slid", m.slid);
    visit("tears", m.tears);
    visit_ledger(m.ledger, visit);
  }

 private:
  template <class Ledger, class Visit>
  static void visit_ledger(Ledger& ledger, Visit& visit) {
    visit("external", ledger.external);
    visit("kinetic", ledger.kinetic);
    visit("friction", ledger.friction);
    visit("fracture", ledger.fracture);
    visit("damping", ledger.damping);
    visit("impact", ledger.impact);
    visit("numerical", ledger.numerical);
    visit("error", ledger.error);
    visit("stored_strain", ledger.stored.strain);
    visit("stored_springs", ledger.stored.springs);
    visit("stored_bonds", ledger.stored.bonds);
    visit("stored_contact", ledger.stored.contact);
    visit("stored_friction", ledger.stored.friction);
    visit("stored_impacts", ledger.stored.impacts);
  }
};

constexpr std::size_t of_pose = 6;
constexpr std::array poses_of_course = {&BodyCourse::before, &BodyCourse::now, &BodyCourse::velocity,
                                        &BodyCourse::acceleration, &BodyCourse::lag};

void put_motions(const std::vector<RigidMotion>& motions, std::vector<double>& out) {
  for (const RigidMotion& motion : motions)
    out.insert(out.end(), {motion.velocity.x(), motion.velocity.y(), motion.spin});
}

std::vector<RigidMotion> motions_of(const std::vector<double>& numbers) {
  std::vector<RigidMotion> out;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    out.push_back({{numbers[i], numbers[i + 1]}, numbers[i + 2]});
  return out;
}

void put_forces(const std::vector<Vec6>& forces, std::vector<double>& out) {
  for (const Vec6& force : forces) out.insert(out.end(), force.begin(), force.end());
}

std::vector<Vec6> forces_of(const std::vector<double>& numbers) {
  std::vector<Vec6> out;
  for (std::size_t at = 0; at + of_pose <= numbers.size(); at += of_pose)
    out.emplace_back(Eigen::Map<const Vec6>(numbers.data() + at));
  return out;
}

void put_lists(const MotionMemory& m, RestartData& out) {
  std::vector<double>& courses = out.numbers["courses"];
  for (const BodyCourse& course : m.courses) out.numbers["growths"].push_back(course.growth);
  for (const BodyCourse& course : m.courses)
    for (const auto part : poses_of_course)
      courses.insert(courses.end(), (course.*part).begin(), (course.*part).end());
  put_forces(m.holding, out.numbers["holding"]);
  put_forces(m.meeting, out.numbers["meeting"]);
  std::vector<RigidMotion> steady;
  for (const BodyCourse& course : m.courses) steady.push_back(course.steady);
  put_motions(steady, out.numbers["steady"]);
  put_motions(m.owed, out.numbers["owed"]);
  out.numbers["fracture_of"] = m.ledger.fracture_of;
  out.integers["bonds"] = {m.bonds.begin(), m.bonds.end()};
  put_all(out, "histories", m.histories);
  for (const auto& [first, second] : m.joined) {
    out.integers["joined"].push_back(first);
    out.integers["joined"].push_back(second);
  }
  for (const auto& [key, kept] : m.sliders.all()) {
    std::vector<std::int64_t>& keys = out.integers["sliders"];
    keys.insert(keys.end(), {key.body, key.vertex, key.other, key.edge, key.is_corner});
    out.numbers["sliders"].push_back(kept.slip);
    out.numbers["sliders"].push_back(kept.force);
    out.numbers["approaches"].push_back(kept.approach);
  }
}

/// A list that may not be there when it is empty.
template <class Values>
Values list(const std::map<std::string, Values>& all, const std::string& name) {
  const auto found = all.find(name);
  return found == all.end() ? Values() : found->second;
}

void take_lists(const RestartData& data, MotionMemory& m) {
  const std::vector<double> courses = list(data.numbers, "courses"), growths = list(data.numbers, "growths");
  for (std::size_t at = 0; at + poses_of_course.size() * of_pose <= courses.size();) {
    const std::size_t body = m.courses.size();
    BodyCourse& course = m.courses.emplace_back();
    for (const auto part : poses_of_course) {
      course.*part = Eigen::Map<const Pose>(courses.data() + at);
      at += of_pose;
    }
    if (body < growths.size()) course.growth = growths[body];
  }
  m.holding = forces_of(list(data.numbers, "holding"));
  m.meeting = forces_of(list(data.numbers, "meeting"));
  const std::vector<RigidMotion> steady = motions_of(list(data.numbers, "steady"));
  for (std::size_t body = 0; body < std::min(steady.size(), m.courses.size()); ++body)
    m.courses[body].steady = steady[body];
  m.owed = motions_of(list(data.numbers, "owed"));
  m.ledger.fracture_of = list(data.numbers, "fracture_of");
  for (const std::int64_t bond : list(data.integers, "bonds"))
    m.bonds.push_back(static_cast<std::size_t>(bond));
  if (!m.bonds.empty()) m.histories = take_all<History>(data, "histories");
  const std::vector<std::int64_t> joined = list(data.integers, "joined"),
                                  keys = list(data.integers, "sliders");
  for (std::size_t i = 0; i + 1 < joined.size(); i += 2)
    m.joined.emplace_back(static_cast<std::uint32_t>(joined[i]), static_cast<std::uint32_t>(joined[i + 1]));
  const std::vector<double> kept = list(data.numbers, "sliders"),
                            approaches = list(data.numbers, "approaches");
  const auto key = [&](std::size_t i) { return static_cast<std::uint32_t>(keys[i]); };
  for (std::size_t i = 0; 5 * i + 4 < keys.size(); ++i)
    m.sliders.set({key(5 * i), key(5 * i + 1), key(5 * i + 2), key(5 * i + 3), keys[5 * i + 4] != 0},
                  {kept.at(2 * i), kept.at(2 * i + 1), i < approaches.size() ? approaches[i] : 0.0});
}

}  // namespace

void write_motion_restart(const std::filesystem::path& path, const MotionRestart& at,
                          const std::string& deck) {
  RestartData data;
  MotionRestart copy = at;
  put(data, "motion", Scalars{copy});
  put_lists(at.motion, data);
  data.texts["deck"] = {deck};
  write_restart(path, data, Flush::to_system);
}

std::optional<MotionRestart> read_motion_restart(const std::filesystem::path& path, const std::string& deck) {
  if (!std::filesystem::exists(path)) return {};
  try {
    const RestartData data = read_restart(path);
    if (data.texts.at("deck").at(0) != deck) return {};
    MotionRestart out;
    Scalars scalars{out};
    RecordReader in(data, "motion");
    Scalars::visit(scalars, in);
    take_lists(data, out.motion);
    return out;
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace dda
