#pragma once

#include "meshing/files/gmsh_model.hpp"
#include "meshing/files/physical_groups.hpp"
#include "meshing/gmsh/frame.hpp"

namespace dda {

/// The GmshModel of the gmsh library: starts it, holds its one current model, stops it.
class GmshSession final : public GmshModel {
 public:
  static std::shared_ptr<const GmshModel> from_geo(const std::string& file, const GmshParameters& parameters,
                                                   const Position& where);
  static std::shared_ptr<const GmshModel> from_msh(const std::string& file, const Position& where);
  static std::shared_ptr<const GmshModel> from_layout(const Layout& layout);

  ~GmshSession() override;
  Layout layout() const override;
  Cells mesh(const ElementWish& wish) const override;

 private:
  GmshSession(const std::vector<std::string>& arguments, Position where);
  void open(const std::string& file);
  void read_groups();
  std::string centre_of(int dimension, int tag) const;
  void apply(const ElementWish& wish) const;
  std::optional<Vec2> fold_of_surfaces() const;
  void refine(const ElementWish& wish) const;
  std::vector<Cell> elements() const;
  std::vector<NamedLine> line_pieces() const;
  std::map<std::string, Vec2> named_points() const;
  std::vector<Shape> shapes() const;

  Position where_;
  Frame frame_;          // of what was drawn; a file has its own
  bool meshed_ = false;  // the file holds the mesh itself
  std::vector<PhysicalGroup> groups_;
};

}  // namespace dda
