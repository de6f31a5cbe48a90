#include "tools/ingest/projection.hpp"

#include "common/error.hpp"
#include "tools/records/dropped.hpp"

#include <proj.h>

#include <cmath>

namespace evbal {
namespace {

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Context = std::unique_ptr<PJ_CONTEXT, DestroyContext>;
using Object = std::unique_ptr<PJ, DestroyObject>;

/// Where a system is used, degrees; `west` is greater than `east` if that is across 180.
struct Area {
  double west = -180.0;
  double south = -90.0;
  double east = 180.0;
  double north = 90.0;

  /// True also somewhat outside, since people use a system beyond its bounds.
  bool holds(LatLon place) const {
    constexpr double kMargin = 10.0;
    const double width = std::fmod(east - west + 360.0, 360.0);
    const double east_of_west = std::fmod(place.lon - west + kMargin + 720.0, 360.0);
    const bool all_round = width == 0.0 || width + 2.0 * kMargin >= 360.0;
    return place.lat >= south - kMargin && place.lat <= north + kMargin &&
           (all_round || east_of_west <= width + 2.0 * kMargin);
  }
};

/// The system of the list of codes that is the same as `crs`, if there is one.
Object same_in_list(PJ_CONTEXT* context, const PJ* crs) {
  constexpr int kSame = 90;  // of 100: equal but for the name
  int* confidence = nullptr;
  PJ_OBJ_LIST* found = proj_identify(context, crs, nullptr, nullptr, &confidence);
  Object same;
  if (found != nullptr && proj_list_get_count(found) > 0 && confidence[0] >= kSame) {
    same.reset(proj_list_get(context, found, 0));
  }
  proj_int_list_destroy(confidence);
  proj_list_destroy(found);
  return same;
}

Area area_of(PJ_CONTEXT* context, const PJ* crs) {
  Area area;
  if (proj_get_area_of_use(context, crs, &area.west, &area.south, &area.east, &area.north, nullptr) == 1 &&
      area.south >= -90.0) {
    return area;
  }
  const Object same = same_in_list(context, crs);
  if (!same ||
      proj_get_area_of_use(context, same.get(), &area.west, &area.south, &area.east, &area.north, nullptr) == 0) {
    return {};
  }
  return area.south >= -90.0 ? area : Area{};
}

/// True for what PROJ takes as a code or as WKT; it also takes names, of which it guesses.
bool names_exactly(const std::string& definition) {
  return definition.find_first_of(":[") != std::string::npos;
}

}  // namespace

struct Projection::System {
  Context context{proj_context_create()};
  std::string complaint;  ///< the last that PROJ logged
  std::string name;
  Area area;
  Object to_degrees;
};

Projection::Projection(const std::string& definition) {
  auto system = std::make_unique<System>();
  PJ_CONTEXT* context = system->context.get();
  proj_context_set_enable_network(context, 0);
  proj_log_level(context, PJ_LOG_ERROR);
  proj_log_func(context, &system->complaint,
                [](void* complaint, int, const char* text) { *static_cast<std::string*>(complaint) = text; });
  const Object crs(names_exactly(definition) ? proj_create(context, definition.c_str()) : nullptr);
  if (!crs || proj_is_crs(crs.get()) == 0) {
    throw bad_input(shown(definition) + " is no coordinate reference system that PROJ knows, such as EPSG:2263" +
                    (system->complaint.empty() ? "" : ": " + shown(system->complaint)));
  }
  system->name = proj_get_name(crs.get());
  const Object degrees(proj_create(context, "EPSG:4326"));
  const Object either_axis(degrees ? proj_create_crs_to_crs_from_pj(context, crs.get(), degrees.get(), nullptr, nullptr)
                                   : nullptr);
  // East before north, whatever order of axes the system has by its definition.
  system->to_degrees.reset(either_axis ? proj_normalize_for_visualization(context, either_axis.get()) : nullptr);
  if (!system->to_degrees) {
    throw bad_input(shown(system->name) + " cannot be turned into WGS84 degrees: " + shown(system->complaint));
  }
  system->area = area_of(context, crs.get());
  system_ = std::move(system);
}

Projection::~Projection() = default;
Projection::Projection(Projection&&) noexcept = default;
Projection& Projection::operator=(Projection&&) noexcept = default;

std::optional<LatLon> Projection::place(double x, double y) const {
  PJ* transformation = system_->to_degrees.get();
  proj_errno_reset(transformation);
  const PJ_COORD turned = proj_trans(transformation, PJ_FWD, proj_coord(x, y, 0.0, 0.0));
  const LatLon place{turned.xy.y, turned.xy.x};
  if (proj_errno(transformation) != 0 || !(std::abs(place.lat) <= 90.0 && std::abs(place.lon) <= 180.0) ||
      !system_->area.holds(place)) {
    return std::nullopt;
  }
  return place;
}

const std::string& Projection::name() const {
  return system_->name;
}

}  // namespace evbal
