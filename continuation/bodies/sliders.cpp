#include "continuation/bodies/sliders.hpp"

namespace dda {

double Slider::reached(const Poses& before, const Poses& at) const {
  const auto moved = [&](std::uint32_t body, const Vec2& offset) {
    return Vec2(place_of(at[body], offset) - place_of(before[body], offset));
  };
  return start + tangent().dot(moved(meeting.key.body, meeting.at) - moved(meeting.key.other, meeting.foot));
}

double Slide::spent_on_way(const Poses& beyond, double share_of_end) const {
  const Vec2 more =
      place_of(beyond[meeting.key.body], meeting.at) - place_of(beyond[meeting.key.other], meeting.foot);
  const double mean = share_of_end * force + (1 - share_of_end) * at_start;
  return std::max(0.0, mean * (slipped + tangent_of(meeting).dot(more)));
}

SliderMemory::Kept SliderMemory::of(const MeetingKey& key) const {
  if (const auto same = kept_.find(key); same != kept_.end()) return same->second;
  const auto first = kept_.lower_bound({key.body, key.vertex, key.other, 0, false});
  if (first == kept_.end()) return {};
  const MeetingKey& near = first->first;
  const bool is_same_pair = near.body == key.body && near.vertex == key.vertex && near.other == key.other;
  return is_same_pair ? first->second : Kept{};
}

}  // namespace dda
