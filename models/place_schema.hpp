#pragma once

#include "framework/schema.hpp"
#include "models/place.hpp"

namespace dda {

/// Declares `at` and `inside` of parameters that derive from Place.
template <class P>
void add_place(Schema<P>& schema) {
  schema.point("at", &P::at, {.text = "The point."})
      .point("inside", &P::inside,
             {.text = "A point inside the block that is meant where several blocks meet at `at`; otherwise "
                      "they share."});
}

}  // namespace dda
