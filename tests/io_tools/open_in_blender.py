"""Opens files in Blender and tells what came in, as JSON.

blender --background --factory-startup --python-exit-code 1 --python open_in_blender.py -- OUT FILE ..

For each file and each importer that takes it: the number of mesh objects, faces, corners, edges,
vertices and texture layers; whether Blender finds something to repair (importers that repair at
once show in the numbers); the smallest and largest texture coordinate; the number of islands of the
texture (faces that follow each other along an edge with equal texture coordinates) and of edges
between them; and how many edges UV > Seams from Islands marks.
"""

import json
import os
import sys

import bpy


def importer(path):
    """The operators that open a file of this kind, by name; older and newer Blenders differ."""
    kind = os.path.splitext(path)[1].lower()
    found = []
    if kind == ".obj":
        if hasattr(bpy.types, "IMPORT_SCENE_OT_obj"):
            found.append(("import_scene.obj", lambda: bpy.ops.import_scene.obj(filepath=path)))
        if "obj_import" in dir(bpy.ops.wm):
            found.append(("wm.obj_import", lambda: bpy.ops.wm.obj_import(filepath=path)))
    elif kind == ".ply":
        if "ply_import" in dir(bpy.ops.wm):
            found.append(("wm.ply_import", lambda: bpy.ops.wm.ply_import(filepath=path)))
        if hasattr(bpy.types, "IMPORT_MESH_OT_ply"):
            found.append(("import_mesh.ply", lambda: bpy.ops.import_mesh.ply(filepath=path)))
    elif kind == ".glb":
        found.append(("import_scene.gltf", lambda: bpy.ops.import_scene.gltf(filepath=path)))
    return found


def give_numpy_its_old_names():
    """Blender 3.4's importer of glTF uses names that NumPy 1.24 took away."""
    try:
        import numpy
    except ImportError:
        return
    if not hasattr(numpy, "bool"):
        numpy.bool = bool


def texture_of(mesh):
    if not mesh.uv_layers:
        return []
    return [tuple(entry.uv) for entry in mesh.uv_layers[0].data]


def edge_sides(mesh, uv):
    """For each edge the faces at it, with the texture coordinates at its two vertices."""
    sides = {}
    for polygon in mesh.polygons:
        loops = list(polygon.loop_indices)
        for here, there in zip(loops, loops[1:] + loops[:1]):
            a, b = mesh.loops[here].vertex_index, mesh.loops[there].vertex_index
            ends = (uv[here], uv[there]) if a < b else (uv[there], uv[here])
            sides.setdefault((min(a, b), max(a, b)), []).append((polygon.index, ends))
    return sides


def islands_of(mesh, uv):
    root = list(range(len(mesh.polygons)))

    def find(i):
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i

    seams = 0
    for sides in edge_sides(mesh, uv).values():
        parted = False
        for face, ends in sides[1:]:
            if ends == sides[0][1]:
                root[find(face)] = find(sides[0][0])
            else:
                parted = True
        seams += parted
    return len({find(i) for i in root}), seams


def seams_from_islands(scene_object):
    """What Blender itself makes of the texture: UV > Seams from Islands."""
    mesh = scene_object.data
    bpy.context.view_layer.objects.active = scene_object
    scene_object.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    done = None
    try:
        bpy.ops.uv.select_all(action="SELECT")
        bpy.ops.uv.seams_from_islands()
        done = True
    except RuntimeError:
        # The operator needs an image editor, which there is none of without a window.
        pass
    bpy.ops.object.mode_set(mode="OBJECT")
    return sum(edge.use_seam for edge in mesh.edges) if done else None


def describe():
    objects = [entry for entry in bpy.data.objects if entry.type == "MESH"]
    result = {"objects": len(objects)}
    if len(objects) != 1:
        return result
    mesh = objects[0].data
    uv = texture_of(mesh)
    result.update(
        faces=len(mesh.polygons),
        corners=len(mesh.loops),
        edges=len(mesh.edges),
        vertices=len(mesh.vertices),
        texture_layers=len(mesh.uv_layers),
        largest_face=max((polygon.loop_total for polygon in mesh.polygons), default=0),
    )
    if uv:
        islands, seams = islands_of(mesh, uv)
        flat = [value for pair in uv for value in pair]
        result.update(islands=islands, seams=seams, low=min(flat), high=max(flat))
        result["seams_by_blender"] = seams_from_islands(objects[0])
    # True when it had to change something; last, because it changes it.
    result["repaired"] = mesh.validate(verbose=True)
    return result


def main():
    out, files = sys.argv[sys.argv.index("--") + 1], sys.argv[sys.argv.index("--") + 2 :]
    results = []
    give_numpy_its_old_names()
    for path in files:
        for name, open_file in importer(path):
            bpy.ops.wm.read_factory_settings(use_empty=True)
            result = {"file": os.path.basename(path), "importer": name}
            try:
                open_file()
                result.update(describe())
            except Exception as error:  # the caller judges it
                result["error"] = str(error)
            results.append(result)
    with open(out, "w", encoding="utf-8") as stream:
        json.dump(results, stream, indent=1)


main()
