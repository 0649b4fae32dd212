#include "runtime/cli/files/png.h"

#include <cairo.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <glib-object.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PLSC_ASAN  // clang's way to say it
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define PLSC_ASAN
#endif
#ifdef PLSC_ASAN
// Fontconfig keeps what it read of fonts until the process ends, in a thread of
// its own, which is no leak of ours. The sanitizer asks these.
// NOLINTBEGIN
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
  return "print_suppressions=0";
}
// NOLINTEND
#endif

namespace plsc::cli {

namespace {

/// px a side; cairo's surfaces end at 32767, and more is a slip.
constexpr double kMostPixels = 20000;

class Library {
 public:
  explicit Library(const std::string& name)
      // Never closed: GLib cannot be loaded a second time.
      : handle_(::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)), name_(name) {}

  bool is_open() const { return handle_ != nullptr; }
  const std::string& name() const { return name_; }
  template <typename Function>
  bool Find(const char* symbol, Function*& function) const {
    function = reinterpret_cast<Function*>(::dlsym(handle_, symbol));
    return function != nullptr;
  }

 private:
  void* handle_;
  std::string name_;
};

/// The functions that are called, of the types that the libraries' headers give
/// them, so that the compiler checks each call.
struct Functions {
  decltype(&rsvg_handle_new_from_data) new_from_data = nullptr;
  decltype(&rsvg_handle_get_intrinsic_size_in_pixels) intrinsic_size = nullptr;
  decltype(&rsvg_handle_render_document) render = nullptr;
  decltype(&g_object_unref) unref = nullptr;
  decltype(&cairo_image_surface_create) surface_create = nullptr;
  decltype(&cairo_surface_status) surface_status = nullptr;
  decltype(&cairo_surface_destroy) surface_destroy = nullptr;
  decltype(&cairo_create) create = nullptr;
  decltype(&cairo_destroy) destroy = nullptr;
  decltype(&cairo_surface_write_to_png_stream) write_png = nullptr;

  bool Find(const Library& rsvg, const Library& cairo, const Library& gobject) {
    return rsvg.Find("rsvg_handle_new_from_data", new_from_data) &&
           rsvg.Find("rsvg_handle_get_intrinsic_size_in_pixels",
                     intrinsic_size) &&
           rsvg.Find("rsvg_handle_render_document", render) &&
           gobject.Find("g_object_unref", unref) &&
           cairo.Find("cairo_image_surface_create", surface_create) &&
           cairo.Find("cairo_surface_status", surface_status) &&
           cairo.Find("cairo_surface_destroy", surface_destroy) &&
           cairo.Find("cairo_create", create) &&
           cairo.Find("cairo_destroy", destroy) &&
           cairo.Find("cairo_surface_write_to_png_stream", write_png);
  }
};

// Calls of a C library must not be left by an exception.
cairo_status_t Append(void* closure, const unsigned char* data,
                      unsigned length) noexcept {
  try {
    static_cast<std::string*>(closure)->append(
        reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_WRITE_ERROR;
  }
}

using Png = Expected<std::string, Failure>;
template <typename T, typename Argument = T>
using Owned = std::unique_ptr<T, void (*)(Argument*)>;

Png Draw(const Functions& call, RsvgHandle* handle, const RsvgRectangle& size) {
  const Owned<cairo_surface_t> surface(
      call.surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(size.width),
                          static_cast<int>(size.height)),
      call.surface_destroy);
  if (call.surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    return Failure("cannot make a PNG: not enough memory");
  {
    const Owned<cairo_t> context(call.create(surface.get()), call.destroy);
    if (call.render(handle, context.get(), &size, nullptr) == FALSE)
      return Failure("cannot make a PNG: librsvg cannot draw the picture");
  }
  std::string png;
  if (call.write_png(surface.get(), Append, &png) != CAIRO_STATUS_SUCCESS)
    return Failure("cannot make a PNG: cairo cannot write the picture");
  return png;
}

}  // namespace

Expected<std::string, Failure> PngOf(const std::string& svg, double scale,
                                     const PngLibraries& libraries) {
  const Library rsvg(libraries.rsvg);
  const Library cairo(libraries.cairo);
  const Library gobject(libraries.gobject);
  for (const Library* library : {&rsvg, &cairo, &gobject})
    if (!library->is_open())
      return Failure(fmt::format(
          "cannot make a PNG: the library {} is missing; install the package "
          "librsvg2-2 (apt-get install librsvg2-2 fonts-dejavu-core), or write "
          "an .svg",
          library->name()));
  Functions call;
  if (!call.Find(rsvg, cairo, gobject))
    return Failure(
        "cannot make a PNG: librsvg 2.52 or newer is needed, or write an .svg");
  const Owned<RsvgHandle, void> handle(
      call.new_from_data(reinterpret_cast<const unsigned char*>(svg.data()),
                         svg.size(), nullptr),
      call.unref);
  double width = 0;
  double height = 0;
  if (!handle || call.intrinsic_size(handle.get(), &width, &height) == FALSE)
    return Failure("cannot make a PNG: librsvg cannot read the picture");
  const RsvgRectangle size{0, 0, std::round(width * scale),
                           std::round(height * scale)};
  const auto is_drawable = [](double pixels) {
    return pixels >= 1 && pixels <= kMostPixels;  // and so not NaN
  };
  if (!is_drawable(size.width) || !is_drawable(size.height))
    return Failure(fmt::format(
        "cannot make a PNG of {} x {} pixels: expected 1 to {} a side; choose "
        "another --scale",
        size.width, size.height, kMostPixels));
  return Draw(call, handle.get(), size);
}

}  // namespace plsc::cli
