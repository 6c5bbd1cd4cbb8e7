#include "framework/base/suggestion.hpp"
#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct ReactionParameters {
  std::string of;
  double scale = 1;
  Position where;
};

/// Force of a support or driven spring on the structure, r = p̄ (δ − l · u), or its moment where it holds a rotation, times a
/// scale.
class ReactionGauge final : public Gauge {
 public:
  explicit ReactionGauge(ReactionParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    Functional out;
    out.add(p_.scale, found(sources));
    return out;
  }
  Dimension dimension() const override { return dimension::force; }
  Dimension dimension_of(const GaugeSources& sources) const override {
    return found(sources).is_moment ? dimension::moment : dimension::force;
  }

 private:
  const Reaction& found(const GaugeSources& sources) const {
    if (const auto found = sources.reactions.find(p_.of); found != sources.reactions.end())
      return found->second;
    std::vector<std::string> names;
    for (const auto& [name, reaction] : sources.reactions) names.push_back(name);
    throw InputError(p_.where, "unknown support or driven spring '" + p_.of + "'" + suggest(p_.of, names));
  }

  ReactionParameters p_;
};

Schema<ReactionParameters> schema() {
  using P = ReactionParameters;
  return Schema<P>(
             "Force of a support or of a driven spring on the structure; of one that holds a rotation its "
             "moment.")
      .text("of", &P::of,
            {.text = "Name of the support (`left`, or `left.x` of one that fixes several directions)."})
      .number("scale", &P::scale, {.fallback = 1.0, .text = "Factor, -1 to turn its sign."});
}

}  // namespace

DDA_REGISTER(gauges(), "reaction", schema(), make_of<ReactionGauge>);

}  // namespace dda
