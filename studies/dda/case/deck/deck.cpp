#include "studies/dda/case/deck/deck.hpp"

#include <fmt/format.h>

#include "framework/deck/messages.hpp"
#include "framework/messages/provenance.hpp"
#include "framework/plugin/plugin.hpp"
#include "models/crack/kind.hpp"
#include "studies/dda/case/deck/written_deck.hpp"

namespace dda {
namespace {

Schema<Units> units_schema() {
  using P = Units;
  return Schema<P>("The two units every number of the deck is in; nothing is converted.")
      .text("length", &P::length, {.fallback = "mm", .text = "Unit of length."})
      .text("force", &P::force, {.fallback = "N", .text = "Unit of force."});
}

Schema<EigenvalueParameters> eigenvalue_schema() {
  using P = EigenvalueParameters;
  return Schema<P>("Lowest eigenvalues of the tangent stiffness, as columns mu_1, mu_2, ... of the curve.")
      .integer("count", &P::count,
               {.fallback = 0, .bounds = at_least(0), .text = "How many; 0 computes none."})
      .integer("every", &P::every,
               {.fallback = 1,
                .bounds = at_least(0),
                .text = "Steps between them; 0 computes them at the start and at the events of `at` only."})
      .list(
          "at", &P::at,
          name_of<EventKind>({{"first_crack", EventKind::first_crack},
                              {"limit_point", EventKind::limit_point},
                              {"turning_point", EventKind::turning_point},
                              {"bifurcation", EventKind::bifurcation},
                              {"landing", EventKind::landing},
                              {"release", EventKind::release},
                              {"end", EventKind::end}}),
          {.fallback = {{}},
           .text = "Events at which they are computed as well. A peak that a jump follows is known only when "
                   "it has passed, and is none of them."})
      .one_of(
          "mass", &P::mass,
          {{"none", EigenvalueMass::none},
           {"unit", EigenvalueMass::unit},
           {"density", EigenvalueMass::density}},
          {.fallback = EigenvalueMass::unit,
           .text = "K φ = μ φ; K φ = μ M φ with the mass of density 1, which no unit of length changes; or "
                   "K φ = ω² M φ with the `density` of the materials: then the frequencies ω/2π are columns "
                   "frequency_1, frequency_2, ... as well [1/s], `nan` of modes that are not stable."});
}

Schema<ReferencePeak> reference_schema() {
  using P = ReferencePeak;
  return Schema<P>(
             "A peak load known from elsewhere, such as that of a straight crack; the run reports by how "
             "much its "
             "own differs.")
      .number("load", &P::load,
              {.dimension = dimension::force, .bounds = above(0), .text = "The peak load of the reference."})
      .text("text", &P::text, {.fallback = "", .text = "What it is and where it comes from."})
      .map("at", &P::at, number_kind({}, {}),
           {.fallback = {{}}, .text = "Values of displacement gauges at that peak: where figures mark it."});
}

Schema<Detail> detail_schema() {
  return Schema<Detail>("A rectangle of which detail.svg shows the deformed blocks at the end.")
      .spot("from", &Detail::from, {.text = "One corner, or the name of a point of the scene."})
      .spot("to", &Detail::to, {.text = "The corner opposite."});
}

Schema<RecordParameters> record_schema() {
  using P = RecordParameters;
  return Schema<P>("What is kept beside the curve.")
      .integer("fields_every", &P::fields_every,
               {.fallback = 10,
                .bounds = at_least(0),
                .text = "Fields are stored every so many steps (0 = never), and always at start, landings, "
                        "peak and end."})
      .map("at", &P::at, list_of(number_kind({}, {})),
           {.fallback = {{}}, .text = "Gauge values on which steps land exactly and fields are stored."})
      .text("folder", &P::folder, {.fallback = "", .text = "Run folder; runs/<name of the deck> if empty."})
      .boolean("condition", &P::condition,
               {.fallback = false,
                .text = "Estimate the condition of the stiffness at the start (intact) and at the end; "
                        "costs six factorisations."})
      .boolean("stiffness", &P::stiffness,
               {.fallback = false,
                .text = "The stiffness at the start and at the end by contribution, in stiffness.txt and "
                        "stiffness.json; for assemblies of at most 10 blocks."})
      .section("eigenvalues", &P::eigenvalues, eigenvalue_schema())
      .section("reference_peak", &P::reference_peak, reference_schema())
      .section("detail", &P::detail, detail_schema());
}

/// Whether a section says nothing but what holds without it.
template <class T>
bool is_default(const Schema<T>& schema, const T& section) {
  return to_yaml(schema.echo(section)) == to_yaml(schema.echo(schema.read(Node::map())));
}

/// A deck has a path, a motion, or both; sections of a path it has not would do nothing.
void check_course(const Deck& deck, const Position& where, Findings& findings) {
  if (deck.has_path()) {
    if (deck.supports.empty())
      findings.add(where, "`supports`: a structure that is loaded along a path needs one at least");
    return;
  }
  if (!deck.motion)
    return findings.add(where,
                        "a deck needs `stages`, which load the structure, or a `motion`, which lets it go");
  const std::string without = " needs `stages`: without them there is no path";
  RecordParameters record = deck.record;
  record.folder.clear();
  if (!deck.cracks.empty()) findings.add(where, "`cracks`" + without);
  if (!is_default(path_schema(), deck.path)) findings.add(where, "`path`" + without);
  if (!is_default(record_schema(), record))
    findings.add(where, "`record`" + without + "; only `folder` may stay");
}

void check_water(const Deck& deck, Findings& findings) {
  if (!deck.motion) return;
  for (const auto& [name, interface] : deck.interfaces)
    if (interface.water)
      findings.add(interface.where,
                   fmt::format("interface '{}': `water` presses on cracks along a path; what it does "
                               "between bodies that move is not known to `motion`",
                               name));
}

void check_deck(const Deck& deck, const Position& where, Findings& findings) {
  check_course(deck, where, findings);
  check_water(deck, findings);
}

/// Of a deck, or of one as a file has it.
template <class D>
void add_deck(Schema<D>& schema) {
  schema.text("title", &Deck::title, {.fallback = "", .text = "What this deck is about."})
      .section("units", &Deck::units, units_schema())
      .section("scene", &Deck::scene, scene_schema());
  add_model(schema);
  schema.list(
      "cracks", &Deck::cracks, crack_kind(),
      {.at_least = 0,
       .text = "Cracks that run through blocks, whatever their pattern, where the stress sends them."});
  schema.section("path", &Deck::path, path_schema())
      .section("motion", &Deck::motion, motion_schema())
      .section("record", &Deck::record, record_schema())
      .value("sweep", &Deck::sweep, anything_kind(),
             {.text =
                  "Makes the deck many runs: keys with the values they take. `dda explain sweep` shows how."})
      .check(check_deck);
}

template <class D>
Schema<D> empty_schema() {
  return Schema<D>("A structure, its loads, and the path that is to be followed.");
}

Schema<Deck> make_schema() {
  Schema<Deck> schema = empty_schema<Deck>();
  add_deck(schema);
  return schema;
}

Schema<WrittenDeck> make_written_schema() {
  using P = WrittenDeck;
  Schema<P> schema = empty_schema<P>();
  schema
      .text("extends", &P::extends,
            {.text = "A deck that this one is built on, from the folder of this file: keys of maps add up, "
                     "everything else "
                     "replaces what that deck says, and so does a map with another `type`; null drops it."})
      .value("variables", &P::variables, variables_kind(),
             {.text = "Numbers by name, or expressions of others, in any order: {D: 100, a0: D/6}. Wherever "
                      "a deck has a "
                      "number, and in the values of --set and of sweeps, an expression may stand. `dda "
                      "explain variables` "
                      "has what is in one."});
  add_deck(schema);
  return schema;
}

}  // namespace

const Schema<Deck>& deck_schema() {
  static const Schema<Deck> schema = make_schema();
  return schema;
}

const Schema<WrittenDeck>& written_deck_schema() {
  static const Schema<WrittenDeck> schema = make_written_schema();
  return schema;
}

std::string effective_deck(const DeckFile& file) {
  std::string out = "# Every parameter of " + file.path.filename().string() + " as ddapath " +
                    provenance().version + " read it.\n";
  for (const std::filesystem::path& plugin : loaded_plugins()) out += "# --plugin " + plugin.string() + "\n";
  for (const std::string& assignment : file.overrides) out += "# --set " + assignment + "\n";
  return out + to_yaml(deck_schema().echo(file.deck));
}

}  // namespace dda
