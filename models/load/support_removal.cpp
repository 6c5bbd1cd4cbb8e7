#include "models/load/load.hpp"

namespace dda {
namespace {

struct SupportRemovalParameters {
  std::string support;
  Position where;
};

/// Props, centrings, the ground in an opening: the force r that a support bears when the stage begins takes its place as
/// (1 − λ) r, while its springs are gone.
class SupportRemoval final : public Load {
 public:
  explicit SupportRemoval(SupportRemovalParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body&) const override {
    stage.removed.push_back({p_.support, p_.where});
  }

 private:
  SupportRemovalParameters p_;
};

Schema<SupportRemovalParameters> schema() {
  using P = SupportRemovalParameters;
  return Schema<P>(
             "A support that is taken away: what it bears when the stage begins is let go with the load "
             "factor; the stage needs `until: {load_factor: 1}`.")
      .text("support", &P::support, {.text = "Name of the support."});
}

}  // namespace

DDA_REGISTER(loads(), "support_removal", schema(), make_of<SupportRemoval>);

}  // namespace dda
