"""Opens series of field files and prints as JSON what arrived: {path: [[time, points, cells, {field: components}]]}.
Run with pvpython: ParaView chooses the reader by the name of the file. usage: _read_series.py PATH..."""

import json
import sys

from paraview.simple import OpenDataFile

found = {}
for path in sys.argv[1:]:
    reader = OpenDataFile(path)
    found[path] = []
    for time in reader.TimestepValues if reader else []:
        reader.UpdatePipeline(time)
        data, fields = reader.GetDataInformation(), reader.PointData
        found[path].append([time, data.GetNumberOfPoints(), data.GetNumberOfCells(),
                            {name: fields[name].GetNumberOfComponents() for name in fields.keys()}])
print("found " + json.dumps(found))
