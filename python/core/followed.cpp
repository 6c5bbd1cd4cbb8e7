#include "python/core/followed.hpp"

namespace dda::python {

Followed::Followed(DeckFile deck)
    : run_(std::move(deck)),
      fields_(run_.simulation().body(), run_.simulation().deck(), run_.simulation().equilibrium(),
              run_.simulation().deck().units) {}

AcceptedPoint::AcceptedPoint(std::shared_ptr<const Followed> followed, Point point)
    : followed_(std::move(followed)),
      point_(std::move(point)),
      at_(followed_->run().simulation().walker().here()),
      stage_(followed_->run().simulation().followed_stage() + 1),
      num_blocks_(followed_->equilibrium().num_blocks()) {
  const Simulation& simulation = followed_->run().simulation();
  load_ = at_.state.value(simulation.path().load_gauge());
  for (const NamedGauge& gauge : simulation.loading().gauges)
    gauges_.emplace_back(gauge.name, at_.state.value(gauge.functional));
  for (const auto& [name, reaction] : simulation.loading().reactions)
    reactions_.emplace_back(name, at_.state.value(reaction));
  at_.history = simulation.system().history();
}

const Fields::Interface& AcceptedPoint::interface() const {
  if (!interface_)
    interface_ = std::make_unique<const Fields::Interface>(
        followed_->fields().interface_at({.step = point_.step, .state = at_.state, .history = at_.history}));
  return *interface_;
}

const Outlines& AcceptedPoint::outlines() const {
  if (outlines_) return *outlines_;
  const Fields& fields = followed_->fields();
  const auto& blocks = fields.body().assembly.blocks;
  Outlines out{.vertices = {}, .displacements = {}, .offsets = {0}, .region = {}};
  for (std::size_t b = 0; b < num_blocks_; ++b)
    for (const auto& part : fields.moved_parts(BlockId(b), displacements())) {
      for (const auto& [x, u] : part) {
        out.vertices.insert(out.vertices.end(), {x.x(), x.y()});
        out.displacements.insert(out.displacements.end(), {u.x(), u.y()});
      }
      out.offsets.push_back(static_cast<std::int64_t>(out.vertices.size() / 2));
      out.region.push_back(blocks[b].region);
    }
  outlines_ = std::make_unique<const Outlines>(std::move(out));
  return *outlines_;
}

}  // namespace dda::python
