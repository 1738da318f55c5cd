#include "surface/surface_rows.h"

#include "surface/height_map_rows.h"
#include "surface/perlin_rows.h"
#include "surface/regions/region_rows.h"
#include "surface/ridged_rows.h"
#include "surface/warped_rows.h"

namespace talus::terrain {

std::unique_ptr<SurfaceRows> make_surface_rows(const Surface& surface, InstructionSet set) {
  switch (surface.kind) {
    case SurfaceKind::perlin:
      break;
    case SurfaceKind::ridged:
      return std::make_unique<RidgedRows>(surface, set);
    case SurfaceKind::warped:
      return std::make_unique<WarpedRows>(surface, set);
    case SurfaceKind::regions:
      return std::make_unique<RegionRows>(surface, set);
    case SurfaceKind::height_map: {
      if (surface.map.outside != Outside::blend) return std::make_unique<HeightMapRows>(surface, nullptr);
      Surface around = surface;
      around.kind = surface.map.around;
      return std::make_unique<HeightMapRows>(surface, make_surface_rows(around, set));
    }
  }
  return std::make_unique<PerlinRows>(surface, set);
}

}  // namespace talus::terrain
