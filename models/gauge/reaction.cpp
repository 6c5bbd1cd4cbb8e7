#include "framework/base/suggestion.hpp"
#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct ReactionParameters {
  std::string of;
  double scale = 1;
  Position where;
};

/// Force of a support or driven spring on the structure, r = p̄ (δ − l · u), times a scale.
class Reaction final : public Gauge {
 public:
  explicit Reaction(ReactionParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    const auto found = sources.reactions.find(p_.of);
    if (found == sources.reactions.end()) {
      std::vector<std::string> names;
      for (const auto& [name, functional] : sources.reactions) names.push_back(name);
      throw InputError(p_.where, "unknown support or driven spring '" + p_.of + "'" + suggest(p_.of, names));
    }
    Functional out;
    out.add(p_.scale, found->second);
    return out;
  }
  Dimension dimension() const override { return dimension::force; }

 private:
  ReactionParameters p_;
};

Schema<ReactionParameters> schema() {
  using P = ReactionParameters;
  return Schema<P>("Force of a support or of a driven spring on the structure.")
      .text("of", &P::of,
            {.text = "Name of the support (`left`, or `left.x` of one that fixes several directions)."})
      .number("scale", &P::scale, {.fallback = 1.0, .text = "Factor, -1 to turn its sign."});
}

}  // namespace

DDA_REGISTER(gauges(), "reaction", schema(), make_of<Reaction>);

}  // namespace dda
