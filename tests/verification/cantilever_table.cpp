// Prints the tables of studies/elastic-cantilever as markdown.
#include <fmt/format.h>

#include "verification/cantilever.hpp"

namespace dda::verification {
namespace {

struct Shape {
  std::string name;
  std::vector<std::string> subdivisions;  ///< coarse to fine
};

std::string grid(int columns, const std::string& shape) {
  return fmt::format("{{type: grid, columns: {}, rows: {}, shape: {}}}", columns, columns / 4, shape);
}

std::string voronoi(int blocks, int iterations) {
  return fmt::format("{{type: voronoi, blocks: {}, seed: 1, iterations: {}}}", blocks, iterations);
}

std::vector<Shape> shapes() {
  std::vector<Shape> out{{"quads", {}}, {"triangles", {}}, {"Voronoi (Lloyd)", {}}, {"Voronoi (random)", {}}};
  for (const int columns : {16, 32, 64}) {
    const int blocks = columns * columns / 4;
    out[0].subdivisions.push_back(grid(columns, "quads"));
    out[1].subdivisions.push_back(grid(columns, "triangles"));
    out[2].subdivisions.push_back(voronoi(blocks, 100));
    out[3].subdivisions.push_back(voronoi(blocks, 0));
  }
  return out;
}

void consistent_table(const Cantilever& beam) {
  fmt::print("Consistent treatment, α = 0.51 / 0.6 / 1 / 2 (two Gauss points per side):\n\n");
  fmt::print("| blocks | coarse (64; triangles 128) | 256; 512 | 1024; 2048 |\n|---|---|---|---|\n");
  for (const Shape& shape : shapes()) {
    fmt::print("| {} |", shape.name);
    for (const std::string& subdivision : shape.subdivisions) {
      std::string cell;
      for (const double alpha : {0.51, 0.6, 1.0, 2.0}) {
        const std::string joint = fmt::format("treatment: {{type: consistent, alpha: {}}}", alpha);
        cell += fmt::format("{} {:.2g}", cell.empty() ? "" : " /",
                            solve_cantilever(beam, subdivision, joint).error);
      }
      fmt::print("{} |", cell);
    }
    fmt::print("\n");
  }
}

void penalty_table(const Cantilever& beam) {
  fmt::print("\nClassic penalty k = α E/(distance of the centroids), finest blocks of each shape:\n\n");
  fmt::print("| blocks, points | α = 1 | 2 | 4 | 10 | 100 | 1e4 |\n|---|---|---|---|---|---|---|\n");
  for (const std::string points : {"vertices", "gauss", "midpoint"})
    for (const Shape& shape : shapes()) {
      if (shape.name == "triangles" && points == "midpoint") continue;  // three hinges per block: a mechanism
      fmt::print("| {}, {} |", shape.name, points);
      for (const double alpha : {1.0, 2.0, 4.0, 10.0, 100.0, 1e4}) {
        const std::string joint =
            fmt::format("treatment: {{type: penalty, factor: {}}}, points: {}", alpha, points);
        fmt::print(" {:.2g} |", solve_cantilever(beam, shape.subdivisions.back(), joint).error);
      }
      fmt::print("\n");
    }
}

}  // namespace
}  // namespace dda::verification

int main() {
  const dda::verification::Cantilever beam;
  dda::verification::consistent_table(beam);
  dda::verification::penalty_table(beam);
}
