#include "studies/dda/record/interface_record.hpp"

#include <cmath>

#include "studies/dda/record/json_of.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

/// What the points of one interface have come to.
struct Tally {
  double dissipated = 0, area = 0, cracked_area = 0, opening = 0, sliding = 0;
  Vec2 widest{0, 0}, farthest{0, 0};

  void add(const InterfacePoint& point, const History& h, const Vec2& w) {
    dissipated += point.weight * h.dissipated;
    area += point.weight;
    const bool is_cracked = h.dissipated > 0;
    if (is_cracked) cracked_area += point.weight;
    if (!is_cracked && std::isfinite(point.law->initial_kappa(point.stiffness))) return;  // intact; dry joints open at once
    if (w.x() > opening) {
      opening = w.x();
      widest = point.x;
    }
    if (std::abs(w.y()) > sliding) {
      sliding = std::abs(w.y());
      farthest = point.x;
    }
  }

  Json json(const FirstCrack& first) const {
    Json out{{"dissipated_energy", dissipated}, {"cracked_share", area > 0 ? cracked_area / area : 0}};
    if (first.step >= 0) out["first_crack"] = {{"step", first.step}, {"at", json_of(first.at)}};
    if (first.step < 0 && opening == 0 && sliding == 0) return out;
    out["widest"] = {{"opening", opening}, {"at", json_of(widest)}};
    out["farthest"] = {{"sliding", sliding}, {"at", json_of(farthest)}};
    return out;
  }
};

}  // namespace

InterfaceRecord::InterfaceRecord(const Equilibrium& equilibrium, const Units& units, RunMemory& memory)
    : equilibrium_(equilibrium), energy_unit_(unit_of(dimension::energy, units)), memory_(memory) {
  memory_.first_cracks.resize(equilibrium.interfaces().names.size());
}

RecordedColumns InterfaceRecord::columns() const {
  const std::string prefix = "dissipated_energy_";
  RecordedColumns out{{{prefix, ""}, nullptr}};
  for (const std::string& name : equilibrium_.interfaces().names)
    out.push_back({{prefix + name, energy_unit_},
                   [this, i = out.size() - 1](const RecordedStep&) { return energies_[i]; }});
  return out;
}

void InterfaceRecord::look(const RecordedStep& at) {
  note_first_cracks(at.now.step, at.history);
  energies_.assign(memory_.first_cracks.size(), 0);
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (point.interface >= 0)
      energies_[static_cast<std::size_t>(point.interface)] += point.weight * at.history[p].dissipated;
  }
}

void InterfaceRecord::note_first_cracks(int step, const std::vector<History>& history) {
  std::vector<double> most(memory_.first_cracks.size());
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (point.interface < 0) continue;
    const auto i = static_cast<std::size_t>(point.interface);
    FirstCrack& first = memory_.first_cracks[i];
    if ((first.step >= 0 && first.step < step) || history[p].dissipated <= most[i]) continue;
    most[i] = history[p].dissipated;
    first = {step, point.x};
  }
}

Json InterfaceRecord::summary(const Fields& fields, const StoredState& end) const {
  const auto& names = equilibrium_.interfaces().names;
  std::vector<Tally> tallies(names.size());
  const Fields::Interface here = fields.interface_at(end);
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (point.interface >= 0)
      tallies[static_cast<std::size_t>(point.interface)].add(point, end.history[p], here.opening[p]);
  }
  Json out = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) out[names[i]] = tallies[i].json(memory_.first_cracks[i]);
  return out;
}

}  // namespace dda
