#pragma once

#include "meshing/gmsh_model.hpp"

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
  struct Group {
    int dimension = 0, tag = 0;
    std::string role, name;
    std::vector<int> entities;
  };
  GmshSession(const std::vector<std::string>& arguments, Position where);
  void open(const std::string& file);
  void read_groups();
  void check_group(const Group& group, Findings& findings) const;
  void check_entities(Findings& findings) const;
  void apply(const ElementWish& wish) const;
  void refine(const ElementWish& wish) const;
  std::vector<Cell> elements() const;
  std::vector<NamedLine> line_pieces() const;
  std::map<std::string, Vec2> named_points() const;
  std::vector<Shape> shapes() const;

  Position where_;
  bool meshed_ = false;  // the file holds the mesh itself
  std::vector<Group> groups_;
};

}  // namespace dda
