# ParaView for the scripts of this folder; sourced after common.sh, not run.
#
# ParaView_DIR names the CMake package of a ParaView to build with. Without it, Debian's is taken:
# its Python cannot be installed beside VTK's, so its packages are unpacked below build/ as well.
paraview_prefix="$project/build/paraview-prefix"

install_paraview() {
  if [ -n "${ParaView_DIR:-}" ]; then
    return
  fi
  packages+=(paraview paraview-dev libqt5svg5-dev)
  install_packages
  if [ -x "$paraview_prefix/usr/bin/pvpython" ]; then
    return
  fi
  say "Unpacking ParaView and its Python into build/paraview-prefix"
  local folder
  folder=$(mktemp -d)
  chmod 755 "$folder" # apt's own user writes there
  (cd "$folder" && apt-get download -qq paraview paraview-dev python3-paraview)
  mkdir -p "$paraview_prefix"
  for package in "$folder"/*.deb; do
    dpkg-deb -x "$package" "$paraview_prefix"
  done
  rm -r "$folder"
}

paraview_package() {
  if [ -n "${ParaView_DIR:-}" ]; then
    echo "$ParaView_DIR"
  else
    dirname "$(ls "$paraview_prefix"/usr/lib/*/cmake/paraview-*/paraview-config.cmake)"
  fi
}

# Lets the commands that follow (paraview, pvpython, pvbatch, pvserver, ctest) be of that ParaView.
use_paraview() {
  if [ -z "${ParaView_DIR:-}" ]; then
    LD_LIBRARY_PATH=$(dirname "$(dirname "$(paraview_package)")")
    PYTHONPATH="$paraview_prefix/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
    PATH="$paraview_prefix/usr/bin:$PATH"
    export LD_LIBRARY_PATH PYTHONPATH PATH
  fi
}
