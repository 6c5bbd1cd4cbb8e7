#include "meshing/subdivision/subdivision.hpp"

namespace dda {

Family<Subdivision>& subdivisions() {
  static Family<Subdivision> family("subdivision", "How the regions of the scene are cut into blocks.");
  return family;
}

}  // namespace dda
