"""The filters that users reach for first: tubes by radius, glyphs along axes and velocities."""

import unittest

import numpy as np
from decks import THICK, THIN, moving_frame
from program import ProgramTest
from reading import arrays_of, frame_at, open_file, points_of, times_of
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkLineSource

POINTS = vtkDataObject.FIELD_ASSOCIATION_POINTS


def lines_of(grid, subdivisions):
    """ParaView's Extract Surface, with its Nonlinear Subdivision Level."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetNonlinearSubdivisionLevel(subdivisions)
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def tube_of(lines):
    """ParaView's Tube with Scalars: radius, Vary Radius: By Absolute Scalar."""
    tube = vtkTubeFilter()
    tube.SetInputData(lines)
    tube.SetInputArrayToProcess(0, 0, 0, POINTS, "radius")
    tube.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tube.SetNumberOfSides(8)
    tube.Update()
    return tube.GetOutput()


def glyph_ends(grid, vector, scaled):
    """Ends of glyphs that are lines of length 1 along a vector, or as long as it is; [N, 3]."""
    source = vtkLineSource()
    source.SetPoint1(0, 0, 0)
    source.SetPoint2(1, 0, 0)
    glyph = vtkGlyph3D()
    glyph.SetInputData(grid)
    glyph.SetSourceConnection(source.GetOutputPort())
    glyph.SetInputArrayToProcess(1, 0, 0, POINTS, vector)
    glyph.SetVectorModeToUseVector()
    glyph.OrientOn()
    if scaled:
        glyph.SetScaleModeToScaleByVector()
    else:
        glyph.SetScaleModeToDataScalingOff()
    glyph.Update()
    return points_of(glyph.GetOutput())[1::2]


class Filters(ProgramTest):
    def frames(self, order):
        self.gxrod("run", self.write("frame.toml", moving_frame(order)), "--quiet", "--force")
        reader = open_file(self.folder / "frame.vtkhdf")
        return [frame_at(reader, time) for time in times_of(reader)]

    def test_tubes_are_as_thick_as_the_rods(self):
        for order in (1, 2, 3, 4):
            for subdivisions in (1, 2, 3):
                with self.subTest(order=order, subdivisions=subdivisions):
                    for frame in self.frames(order):
                        self.assert_tubes(lines_of(frame, subdivisions))

    def assert_tubes(self, lines):
        tube = tube_of(lines)
        self.assertGreater(tube.GetNumberOfCells(), 0)
        centres, on_tubes = points_of(lines).astype(float), points_of(tube).astype(float)
        radii = arrays_of(lines.GetPointData())["radius"]
        # Eight points around each point of a line; around one that rods share, eight for each rod.
        to_centres = np.linalg.norm(on_tubes[:, None] - centres[None], axis=2)
        is_on_ring = np.abs(to_centres / np.where(radii > 0, radii, np.inf) - 1) < 1e-4
        self.assertTrue(is_on_ring.any(axis=1).all())
        self.assertTrue((is_on_ring.sum(axis=0)[radii > 0] >= 8).all())
        # Subdivided, the leap from the leg to the thinner joint overshoots by an eighth.
        self.assertAlmostEqual(radii.max(), THICK, delta=0.126 * (THICK - THIN))
        self.assertAlmostEqual(radii[radii > 0].min(), THIN)

    def test_lines_run_on_without_folding_back(self):
        for order in (1, 2, 3, 4):
            for subdivisions in (1, 2, 3):
                with self.subTest(order=order, subdivisions=subdivisions):
                    lines = lines_of(self.frames(order)[0], subdivisions)
                    points = points_of(lines)
                    # The lines of the arc's three elements come after the vertices of the two bodies.
                    self.assertEqual(lines.GetNumberOfVerts(), 2)
                    for line in range(2, 5):
                        ids = lines.GetCell(line).GetPointIds()
                        along = points[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]]
                        angle = np.arctan2(along[:, 1], along[:, 0])
                        self.assertGreater(np.diff(angle).min(), 0)
                        np.testing.assert_allclose(np.linalg.norm(along, axis=1), 2, rtol=1e-2)

    def test_glyphs_point_along_axes_and_velocities(self):
        for frame in self.frames(2):
            points, arrays = points_of(frame), arrays_of(frame.GetPointData())
            for axis in ("axis_x", "axis_y", "axis_z"):
                np.testing.assert_allclose(glyph_ends(frame, axis, False), points + arrays[axis], atol=1e-5)
            ends = glyph_ends(frame, "velocity", True)
            np.testing.assert_allclose(ends, points + arrays["velocity"], atol=1e-5)
        self.assertGreater(np.linalg.norm(arrays["velocity"], axis=1).max(), 1.0)


if __name__ == "__main__":
    unittest.main()
