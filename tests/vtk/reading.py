"""Results as VTK's reader shows them, in the way in which ParaView asks for a time."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader


def open_file(path):
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    return reader


def times_of(reader):
    """The times that the reader offers."""
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    return np.array(times if times else [])


def frame_at(reader, time):
    """The grid at a time, asked for through the pipeline."""
    reader.UpdateTimeStep(time)
    return copy_of(reader.GetOutput())


def frame_of_step(reader, step):
    """The grid of a step, asked for by its number."""
    reader.SetStep(step)
    reader.Update()
    return copy_of(reader.GetOutput())


def copy_of(grid):
    copy = vtkUnstructuredGrid()
    copy.DeepCopy(grid)
    return copy


def points_of(grid):
    """Positions, [N, 3]."""
    return vtk_to_numpy(grid.GetPoints().GetData())


def arrays_of(data):
    """Name → values, of a grid's point or cell data."""
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


def cells_of(grid):
    """VTK type and point numbers of each cell."""
    cells = []
    for i in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(i).GetPointIds()
        cells.append((grid.GetCellType(i), [ids.GetId(k) for k in range(ids.GetNumberOfIds())]))
    return cells


def curve_of(grid, cell, parameters):
    """Points of a curve's cell where VTK evaluates it, [P, 3]; the parameters run from 0 to 1."""
    cell = grid.GetCell(cell)
    point, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
    points = []
    for parameter in parameters:
        cell.EvaluateLocation(reference(0), [parameter, 0, 0], point, weights)
        points.append(list(point))
    return np.array(points)

