#include "apps/record/hdf5_api.hpp"

#include "apps/record/record_error.hpp"

#ifdef SWIRL_HDF5_SONAME
#include <dlfcn.h>

#include <initializer_list>
#include <string>
#endif

namespace swirl::apps::hdf5 {

namespace {

#ifdef SWIRL_HDF5_SONAME

constexpr auto load_action = "cannot load HDF5's library";

/// By the name that the linker would have noted; where that lies on none of the loader's paths, the file found at
/// build.
void* load() {
    std::string why;
    for (const char* name : {SWIRL_HDF5_SONAME, SWIRL_HDF5_FILE}) {
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
        if (why.empty()) why = dlerror();
    }
    throw RecordError(load_action, SWIRL_HDF5_SONAME, why);
}

void* find(void* library, const char* name) {
    if (void* symbol = dlsym(library, name)) return symbol;
    throw RecordError(load_action, SWIRL_HDF5_SONAME, std::string("it has no ") + name);
}

#define SWIRL_TEXT_OF(name) #name
#define SWIRL_TEXT(name) SWIRL_TEXT_OF(name)  // of what the macro `name` stands for
#define SWIRL_HDF5_FUNCTION(name) found.name = reinterpret_cast<decltype(found.name)>(find(library, SWIRL_TEXT(name)));
#define SWIRL_HDF5_IDENTIFIER(name) found.name = *static_cast<const hid_t*>(find(library, SWIRL_TEXT(name)));

#else

#define SWIRL_HDF5_FUNCTION(name) found.name = &::name;
#define SWIRL_HDF5_IDENTIFIER(name) found.name = ::name;

#endif

Api find_all() {
    Api found;
#ifdef SWIRL_HDF5_SONAME
    void* library = load();
#endif
    SWIRL_HDF5_FUNCTIONS(SWIRL_HDF5_FUNCTION)
    // Once a file could not be closed (full disk), HDF5 1.10 tries again at exit and crashes. Every handle closes
    // itself, so nothing is left for exit to do. After the library was opened it would be refused.
    found.H5dont_atexit();
    found.H5check_version(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
    found.H5open();
    SWIRL_HDF5_IDENTIFIERS(SWIRL_HDF5_IDENTIFIER)
    return found;
}

}  // namespace

const Api& api() {
    static const Api found = find_all();
    return found;
}

}  // namespace swirl::apps::hdf5
