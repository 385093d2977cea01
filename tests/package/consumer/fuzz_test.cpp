// SPDX-License-Identifier: GPL-3.0-or-later
// A user's property on random surfaces that are hard for meshers; a failure names the simplest recipe.
#include <rapidcheck.h>

#include <iostream>

#include <tetproof/corpus/rapidcheck.hpp>
#include <tetproof/corpus/surfaces.hpp>
#include <tetproof/verify/surface.hpp>

int main() {
  using tetproof::corpus::FuzzSurface;
  // Stands for a property of the user's own mesher.
  const bool good =
      rc::check("the surface is usable, and its name gives it again", [](const FuzzSurface& random) {
        RC_ASSERT(tetproof::verify::judge_surface(random.surface).fault.empty());
        const auto again =
            tetproof::corpus::make_surface("fuzz:" + tetproof::corpus::recipe_text(random.recipe));
        RC_ASSERT(again.vertices == random.surface.vertices);
        RC_ASSERT(again.triangles == random.surface.triangles);
      });
  return good ? 0 : (std::cerr << "see above\n", 1);
}
