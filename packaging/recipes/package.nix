# For nixpkgs. Not tested here: it was written from the list of packages that CMakeLists.txt looks for.
{
  lib,
  stdenv,
  fetchurl,
  cmake,
  console-bridge,
  ninja,
  pkg-config,
  eigen,
  libpng,
  minizip,
  nlohmann_json,
  ode,
  tinyxml-2,
  urdfdom,
  urdfdom-headers,
  yaml-cpp,
  zlib,
}:

stdenv.mkDerivation rec {
  pname = "smurf-tools";
  version = "@VERSION@";

  src = fetchurl {
    url = "@SOURCE@";
    sha256 = "@SHA256@";
  };

  nativeBuildInputs = [ cmake ninja pkg-config ];
  buildInputs = [
    console-bridge eigen libpng minizip nlohmann_json ode tinyxml-2 urdfdom urdfdom-headers yaml-cpp zlib
  ];
  cmakeFlags = [ "-DSMURF_BUILD_TESTS=OFF" "-DSMURF_BUILD_PYTHON=OFF" ];

  meta = {
    description = "@SUMMARY@";
    homepage = "@HOMEPAGE@";
    license = lib.licenses.bsd3;
    mainProgram = "smurf-lint";
    platforms = lib.platforms.unix;
  };
}
