#include "runtime/cli/files/png.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
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

// Of the libraries' documented C interfaces (librsvg 2.52 and later, cairo 1.2
// and later), which are stable within these names of the shared objects.
// Handles are opaque; declared here, their headers and 30 packages with them
// are not needed to build.
using Opaque = void;
struct Rectangle {  // RsvgRectangle
  double x, y, width, height;
};
constexpr int kArgb32 = 0;            // CAIRO_FORMAT_ARGB32
constexpr int kCairoSuccess = 0;      // CAIRO_STATUS_SUCCESS
constexpr int kCairoWriteError = 11;  // CAIRO_STATUS_WRITE_ERROR
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

struct Functions {
  Opaque* (*new_from_data)(const unsigned char*, std::size_t,
                           Opaque**) = nullptr;
  int (*intrinsic_size)(Opaque*, double*, double*) = nullptr;
  int (*render)(Opaque*, Opaque*, const Rectangle*, Opaque**) = nullptr;
  void (*unref)(Opaque*) = nullptr;
  Opaque* (*surface_create)(int, int, int) = nullptr;
  int (*surface_status)(Opaque*) = nullptr;
  void (*surface_destroy)(Opaque*) = nullptr;
  Opaque* (*create)(Opaque*) = nullptr;
  void (*destroy)(Opaque*) = nullptr;
  int (*write_png)(Opaque*, int (*)(void*, const unsigned char*, unsigned),
                   void*) = nullptr;

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
int Append(void* closure, const unsigned char* data, unsigned length) noexcept {
  try {
    static_cast<std::string*>(closure)->append(
        reinterpret_cast<const char*>(data), length);
    return kCairoSuccess;
  } catch (const std::bad_alloc&) {
    return kCairoWriteError;
  }
}

using Png = Expected<std::string, Failure>;
using Owned = std::unique_ptr<Opaque, void (*)(Opaque*)>;

Png Draw(const Functions& call, Opaque* handle, const Rectangle& size) {
  const Owned surface(call.surface_create(kArgb32, static_cast<int>(size.width),
                                          static_cast<int>(size.height)),
                      call.surface_destroy);
  if (call.surface_status(surface.get()) != kCairoSuccess)
    return Failure("cannot make a PNG: not enough memory");
  {
    const Owned context(call.create(surface.get()), call.destroy);
    if (call.render(handle, context.get(), &size, nullptr) == 0)
      return Failure("cannot make a PNG: librsvg cannot draw the picture");
  }
  std::string png;
  if (call.write_png(surface.get(), Append, &png) != kCairoSuccess)
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
  const Owned handle(
      call.new_from_data(reinterpret_cast<const unsigned char*>(svg.data()),
                         svg.size(), nullptr),
      call.unref);
  double width = 0;
  double height = 0;
  if (!handle || call.intrinsic_size(handle.get(), &width, &height) == 0)
    return Failure("cannot make a PNG: librsvg cannot read the picture");
  const Rectangle size{0, 0, std::round(width * scale),
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
