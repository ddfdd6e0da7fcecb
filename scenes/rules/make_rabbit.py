"""The solid of a rabbit, a smooth union of ellipsoids (a shape of our own, no scan), meshed with tetrahedra.

  python scenes/rules/make_rabbit.py 500 scenes/rabbit.mesh         (500 points on the surface, 699 with those inside)
  python scenes/rules/make_rabbit.py 1650 scenes/rabbit-fine.mesh   (3,024)

needs, and made the committed files byte for byte with:
  pip install gmsh==4.15.2 numpy==2.4.6 pyacvd==0.4.0 pymeshfix==0.18.1 pyvista==0.49.1 scikit-image==0.26.0 vtk==9.7.2

Other versions of these tools may make other meshes of the same solid. So the meshes are committed, and tests/web/scene/scenes.test.ts asks of
them what any such mesh must have; `npm run scenes` then writes their JSON.
"""
import sys

import gmsh
import numpy as np
import pyacvd
import pymeshfix
import pyvista
from skimage.measure import marching_cubes

# metres, y upwards: centre and radii
BODY = ((0, -0.45, 0), (0.85, 0.72, 0.62))
# centre, radii, and the width of the blend into what is already there
PARTS = (
  ((0.62, 0.25, 0), (0.42, 0.40, 0.38), 0.18),  # head
  ((0.42, 0.85, 0.17), (0.13, 0.50, 0.12), 0.10),  # ears
  ((0.42, 0.85, -0.17), (0.13, 0.50, 0.12), 0.10),
  ((-0.86, -0.55, 0), (0.22, 0.22, 0.22), 0.10),  # tail
  ((0.50, -1.02, 0.33), (0.38, 0.16, 0.16), 0.12),  # paws
  ((0.50, -1.02, -0.33), (0.38, 0.16, 0.16), 0.12),
  ((-0.35, -0.95, 0.42), (0.45, 0.22, 0.20), 0.12),  # haunches
  ((-0.35, -0.95, -0.42), (0.45, 0.22, 0.20), 0.12),
)


def ellipsoid(points, centre, radii):
  return (np.linalg.norm((points - np.array(centre)) / np.array(radii), axis=-1) - 1) * min(radii)


def smooth_union(a, b, width):
  h = np.clip(0.5 + 0.5 * (b - a) / width, 0, 1)
  return b * (1 - h) + a * h - width * h * (1 - h)


def surface(point_count):
  """Vertices (#P x 3) and triangles (#T x 3) of an even, closed surface mesh of about `point_count` points."""
  axis = np.linspace(-1.6, 1.6, 97)
  grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1)
  distance = ellipsoid(grid, *BODY)
  for centre, radii, width in PARTS:
    distance = smooth_union(distance, ellipsoid(grid, centre, radii), width)
  v, f, _, _ = marching_cubes(distance, 0, spacing=(axis[1] - axis[0],) * 3)
  mesh = pyvista.PolyData(v - 1.6, np.c_[np.full(len(f), 3), f].ravel())
  clusters = pyacvd.Clustering(mesh)
  clusters.subdivide(4)
  clusters.cluster(point_count)
  even = clusters.create_mesh()
  repair = pymeshfix.MeshFix(even.points.astype(float), even.faces.reshape(-1, 4)[:, 1:])
  repair.repair()
  return np.asarray(repair.points, float), np.asarray(repair.faces)


def tetrahedra(v, f):
  """Vertices (#V x 3) and positively oriented tetrahedra (#T x 4) that fill the closed surface."""
  gmsh.initialize()
  gmsh.option.setNumber("General.Terminal", 0)
  skin = gmsh.model.addDiscreteEntity(2)
  gmsh.model.mesh.addNodes(2, skin, list(range(1, len(v) + 1)), v.ravel())
  gmsh.model.mesh.addElementsByType(skin, 2, [], (f + 1).ravel())
  gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop([skin])])
  gmsh.model.geo.synchronize()
  gmsh.option.setNumber("Mesh.MeshSizeMax", 9.0)
  gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 1)
  gmsh.model.mesh.generate(3)
  gmsh.model.mesh.optimize("Netgen")
  tags, coordinates, _ = gmsh.model.mesh.getNodes()
  _, nodes = gmsh.model.mesh.getElementsByType(4)
  gmsh.finalize()
  place = {int(tag): i for i, tag in enumerate(tags)}
  t = np.array([place[int(node)] for node in nodes]).reshape(-1, 4)
  used = np.unique(t)
  renumber = np.full(len(tags), -1)
  renumber[used] = np.arange(len(used))
  v, t = coordinates.reshape(-1, 3)[used], renumber[t]
  a, b, c, d = (v[t[:, i]] for i in range(4))
  flipped = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0
  t[flipped] = t[flipped][:, [0, 2, 1, 3]]
  return v, t


def write_mesh(path, v, t):
  """A Medit mesh as text: vertices, the faces that bound the solid, outwards, and tetrahedra, counted from 1."""
  faces = np.concatenate([t[:, [1, 2, 3]], t[:, [0, 3, 2]], t[:, [0, 1, 3]], t[:, [0, 2, 1]]])
  _, first, count = np.unique(np.sort(faces, 1), axis=0, return_index=True, return_counts=True)
  boundary = faces[first[count == 1]]
  with open(path, "w") as out:
    name = path.split("/")[-1].removesuffix(".mesh")
    out.write(f"MeshVersionFormatted 2\n# {name}: made by scenes/rules/make_rabbit.py\n")
    out.write(f"Dimension 3\nVertices\n{len(v)}\n")
    out.writelines("%.6f %.6f %.6f 0\n" % tuple(p) for p in v)
    for name, rows in (("Triangles", boundary), ("Tetrahedra", t)):
      out.write(f"{name}\n{len(rows)}\n")
      out.writelines(" ".join(str(i + 1) for i in row) + " 0\n" for row in rows)
    out.write("End\n")


if __name__ == "__main__":
  points, path = int(sys.argv[1]), sys.argv[2]
  vertices, tets = tetrahedra(*surface(points))
  write_mesh(path, vertices, tets)
  print(f"{path}: {len(vertices)} vertices, {len(tets)} tetrahedra")
