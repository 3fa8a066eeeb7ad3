#include "mesh/gmsh_library.hpp"

#include <array>

#include "mesh/line_mesh.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Without libgmsh, the error says what to install", "[mesh]") {
    const std::array names{"libgxrod-has-no-such-library.so.1", "libnor-this.so"};
    CHECK_THROWS_AS(load_gmsh(names), MeshError);
    CHECK_THROWS_WITH(
        load_gmsh(names),
        Catch::StartsWith("meshing and reading meshes need libgmsh: apt install libgmsh4.8 on Debian 12, "
                          "libgmsh4.13 on Debian 13 (libgxrod-has-no-such-library.so.1: cannot open"));
}

TEST_CASE("A library that is not Gmsh's is reported", "[mesh]") {
    const std::array names{"libgxrod-has-no-such-library.so.1", "libm.so.6"};
    CHECK_THROWS_WITH(load_gmsh(names), "libgmsh has no function gmshInitialize");
}

}  // namespace gxrod::test
