#include "studies/dda/record/crack_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/crack/front.hpp"
#include "studies/dda/record/json_of.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

std::vector<GrownSegment> of_crack(const std::vector<GrownSegment>& grown, int crack) {
  std::vector<GrownSegment> out;
  std::ranges::copy_if(grown, std::back_inserter(out),
                       [&](const GrownSegment& segment) { return segment.crack == crack; });
  return out;
}

/// Where a crack has begun, or has nothing but a segment ahead.
Vec2 beginning(const CrackFront& front, int crack) {
  const auto& cuts = front.geometry().cuts();
  const auto first = std::ranges::find(cuts, crack, &Cut::crack);
  return first == cuts.end() ? front.tip(crack) : first->start;
}

double mean_turn(const std::vector<GrownSegment>& segments) {
  double sum = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Vec2 before = segments[i - 1].to - segments[i - 1].from, now = segments[i].to - segments[i].from;
    sum += std::abs(std::atan2(cross(before, now), before.dot(now)));
  }
  return 180 / std::numbers::pi * sum / static_cast<double>(segments.size() - 1);
}

/// What the points of a cut have come to.
void add_points(std::size_t cut, const Fields& fields, const Fields::Interface& end, Json& out) {
  double opening = 0, sliding = 0, damage = 0;
  int count = 0;
  for (std::size_t p = 0; p < end.damage.size(); ++p) {
    if (fields.equilibrium().point(p).cut != cut) continue;
    opening = std::max(opening, end.opening[p].x());
    sliding = std::max(sliding, std::abs(end.opening[p].y()));
    damage += end.damage[p];
    ++count;
  }
  out["opening"] = opening;
  out["sliding"] = sliding;
  out["damage"] = damage / std::max(count, 1);
}

/// In the order in which they came; those of a segment end where it does.
Json cuts_of(const CrackFront& front, const std::vector<GrownSegment>& segments, const Fields& fields,
             const Fields::Interface& end) {
  Json out = Json::array();
  const auto& cuts = front.geometry().cuts();
  auto segment = segments.begin();
  for (std::size_t c = 0; c < cuts.size() && segment != segments.end(); ++c) {
    const Cut& cut = cuts[c];
    if (cut.crack != segment->crack || cut.is_provisional) continue;
    Json entry{{"block", cut.block.value()}};
    if (cut.side) entry["side"] = *cut.side;
    entry["from"] = json_of(cut.start);
    entry["to"] = json_of(cut.end);
    entry["step"] = segment->step;
    entry["load"] = segment->load;
    add_points(c, fields, end, entry);
    out.push_back(std::move(entry));
    if (cut.end == segment->to) ++segment;
  }
  return out;
}

}  // namespace

void note_growth(const CrackFront& front, const Measurement& now, std::vector<GrownSegment>& grown) {
  for (int crack = 0; crack < static_cast<int>(front.num_cracks()); ++crack) {
    const auto last =
        std::find_if(grown.rbegin(), grown.rend(), [&](const auto& known) { return known.crack == crack; });
    const Vec2 from = last == grown.rend() ? beginning(front, crack) : last->to;
    if (front.tip(crack) != from) grown.push_back({crack, from, front.tip(crack), now.step, now.load});
  }
}

Json cracks_summary(const CrackFront& front, const std::vector<GrownSegment>& grown, const Fields& fields,
                    const StoredState& end) {
  Json out = Json::array();
  const Fields::Interface here = fields.interface_at(end);
  for (int crack = 0; crack < static_cast<int>(front.num_cracks()); ++crack) {
    const std::vector<GrownSegment> segments = of_crack(grown, crack);
    Json path = Json::array({json_of(beginning(front, crack))});
    double length = 0;
    for (const GrownSegment& segment : segments) {
      path.push_back(json_of(segment.to));
      length += (segment.to - segment.from).norm();
    }
    Json entry{{"path", std::move(path)}, {"length", length}};
    if (segments.size() > 1) entry["mean_turn"] = mean_turn(segments);
    if (!front.end_of(crack).empty()) entry["ended"] = front.end_of(crack);
    entry["cuts"] = cuts_of(front, segments, fields, here);
    out.push_back(std::move(entry));
  }
  return out;
}

}  // namespace dda
