"""Meshes to measure: a ring with bumps, as binary PLY."""

import array
import math
import sys


def write(path, triangles, thickness=1.0):
    """A thinner ring lies within a thicker one."""
    across = max(3, round(math.sqrt(triangles / 4)))
    around = max(3, round(triangles / 2 / across))
    points = array.array("f")
    turns = [2 * math.pi * j / across for j in range(across)]
    waves = [(math.cos(b), math.sin(b), math.cos(5 * b)) for b in turns]
    for i in range(around):
        a = 2 * math.pi * i / around
        cosine, sine, wave = math.cos(a), math.sin(a), 0.03 * math.sin(9 * a)
        for cos_b, sin_b, cos_5b in waves:
            minor = thickness * (0.35 + wave * cos_5b)
            radius = 0.65 + minor * cos_b
            points.extend((radius * cosine, minor * sin_b, radius * sine))
    # A face is the byte 3 and three numbers of four bytes; the bytes are laid by hand, which is fast enough in slices.
    count = 2 * around * across
    corners = array.array("i")
    for i in range(around):
        here, there = i * across, (i + 1) % around * across
        for j in range(across):
            k = (j + 1) % across
            corners.extend((here + j, here + k, there + k, here + j, there + k, there + j))
    if sys.byteorder == "big":
        points.byteswap()
        corners.byteswap()
    numbers = memoryview(corners).cast("B")
    faces = bytearray(13 * count)
    faces[0::13] = bytes([3]) * count
    for byte in range(12):
        faces[1 + byte::13] = numbers[byte::12]
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {around * across}\n"
                   "property float x\nproperty float y\nproperty float z\n"
                   f"element face {count}\nproperty list uchar int vertex_indices\nend_header\n".encode())
        points.tofile(file)
        file.write(faces)
