#!/usr/bin/env bash
# VTK itself reads what the output vtk writes, also after a restart. Without python3-vtk9: skipped.
source "$(dirname "$0")/expect.bash"

if ! /usr/bin/python3 -c "import vtkmodules.vtkIOXML" 2>/dev/null; then
    echo "skipped: /usr/bin/python3 has no VTK (Debian: python3-vtk9)"
    exit 0
fi
example=$here/../../plugins/output/vtk/example.json
expect 0 run "$example" --quiet --output out
/usr/bin/python3 "$here/read_vtp.py" out fall disk

expect 0 run "$example" --quiet --output cut --set '/checkpoint={"every_steps": 40, "keep": 9}'
expect 0 restart cut/checkpoints/checkpoint_00000040.h5 --quiet
/usr/bin/python3 "$here/read_vtp.py" cut fall disk
cmp out/fall.pvd cut/fall.pvd
cmp out/fall_000010.vtp cut/fall_000010.vtp
cmp out/fall_disk_000010.csv cut/fall_disk_000010.csv
