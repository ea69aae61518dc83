# SPDX-License-Identifier: MIT
"""A made-up results file of a study, with answers that a test can know: `write(folder)` makes folder/results.jsonl and its pictures."""
import json
import random
import struct
import zlib

SEED = 7
W, H = 64, 36
TECHNIQUES = {  # name: (time of its published form as a ratio to the bare pass, wrong samples of published per thousand, has counters of a tree)
    "psv": (6.0, 40, True),
    "d-hybrid": (4.0, 30, True),
    "clusters": (3.0, 12, False),
}
RUNGS = {"published": (1.0, 1.0), "conservative": (1.1, 0.1), "certified": (1.3, 0.0)}  # factors of time and error
MAPS = {512: (0.8, 90), 1024: (1.0, 60), 2048: (1.6, 35)}  # size: (time ratio, wrong per thousand)


def png(pixel):
    """An RGB picture of W x H, pixel(x, y) -> (r, g, b)."""
    rows = b"".join(b"\0" + bytes(c for x in range(W) for c in pixel(x, y)) for y in range(H))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", W, H, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def rows():
    noise = random.Random(SEED)

    def row(scene, technique, precision, ratio, wrong, *, frame=0, size=(480, 270), casters=1000, settings=None, varied=(), best_of=None, peer=False,
            tests=0, nodes=0.0, passes=None):
        samples = size[0] * size[1] * 9 // 10
        floor = [0.5 * noise.uniform(0.95, 1.05) * size[0] * size[1] / 129600 for _ in range(5)]
        total = [f * ratio * noise.uniform(0.97, 1.03) for f in floor]
        parts = passes or {"top_build": 0.3, "query": 0.7}
        bins = [wrong // 2, wrong // 4, wrong - wrong // 2 - wrong // 4]
        group = f"{scene}|0|{frame}|0|none|{size[0]}x{size[1]}"
        result = {
            "schema": 1, "kind": "gnomon-study", "group": group, "run": "made up",
            "job": "|".join([group, technique, precision, json.dumps(settings or {}), best_of or "", str(casters)]),
            "scene": f"scenes/{scene}.glb", "name": scene, "camera": 0, "frame": frame, "light": 0, "light_kind": "point",
            "cull": "none", "technique": technique, "precision": precision, "settings": settings or {}, "varied": list(varied), "peer": peer,
            "device": {"name": "made up", "driver": "made up 1.0", "subgroup": 8}, "size": list(size), "triangles": casters + 2,
            "casters": casters, "samples": samples, "in_shadow": samples // 3, "floor_ms": floor,
            "passes": [{"name": n, "ms": [t * share for t in total]} for n, share in parts.items()],
            "total_ms": total, "bytes": {"structure": 96 * casters}, "counters": {"visited_nodes": int(nodes * samples), "test_and_set": tests},
            "check": {"checked": samples, "wrong": wrong, "leaks": wrong // 3, "false_dark": wrong - wrong // 3, "self": 0,
                      "distance": {"pixels": [0, 1, 2], "samples": bins, "max": 3.5, "mean": 1.0}},
        }
        if best_of:
            result["best_of"] = best_of
        return result

    stages = {"key_build": 0.1, "hierarchy_build": 0.3, "traverse": 0.4, "merge": 0.2}
    for index, scene in enumerate(["garden", "room", "gate"]):
        weight = 1 + 0.4 * index
        for technique, (time, wrong, tree) in TECHNIQUES.items():
            for precision, (slower, error) in RUNGS.items():
                yield row(scene, technique, precision, time * slower * weight, int(wrong * error * 116.64 * weight),
                          nodes=20.0 * weight if tree else 0.0, tests=0 if tree else 10**6, passes=None if tree else stages)
        for size, (time, wrong) in MAPS.items():
            moved = () if size == 1024 else ("size",)
            yield row(scene, "shadow-map", "published", time * weight, int(wrong * 116.64 * weight), settings={"size": size, "bias": 1.5},
                      varied=moved)
            yield row(scene, "shadow-map", "published", time * weight, int(wrong * 0.4 * 116.64 * weight), settings={"size": size, "bias": 0.25},
                      varied=(*moved, "bias"), best_of="bias")
        yield row(scene, "embree", "robust", 9.0 * weight, 5, peer=True, passes={"build": 0.5, "query": 0.5})
        yield row(scene, "embree", "fp32", 8.5 * weight, 60, peer=True, passes={"build": 0.5, "query": 0.5})
        missing = row(scene, "ray-query", "fp32", 1.0, 0)
        for key in ("floor_ms", "passes", "total_ms", "bytes", "counters", "check", "samples", "in_shadow"):
            del missing[key]
        yield missing | {"unavailable": "the device lacks rayQuery"}
    for frame in range(1, 6):
        for technique, (time, wrong, tree) in TECHNIQUES.items():
            yield row("gate", technique, "certified", time * (1.3 + 0.2 * frame), 0, frame=frame,
                      nodes=20.0 + frame if tree else 0.0, tests=0 if tree else 10**6 * frame, passes=None if tree else stages)
    for casters in (1000, 4000, 16000):
        for technique, (time, wrong, tree) in TECHNIQUES.items():
            yield row(f"fuzzy_{casters}", technique, "certified", time * casters**0.5 / 10, 0, casters=casters,
                      nodes=casters**0.25, tests=0 if tree else casters * 10)
    for size in ((240, 135), (960, 540)):
        for technique, (time, wrong, tree) in TECHNIQUES.items():
            yield row("garden", technique, "certified", time * 1.3, 0, size=size, nodes=20.0 if tree else 0.0,
                      tests=0 if tree else size[0] * size[1])


def write(folder):
    (folder / "pictures").mkdir(parents=True)
    pictures = {"shaded": lambda x, y: (220, 90, 40) if 20 < x < 40 else (240, 230, 200),
                "truth": lambda x, y: (40, 90, 220) if 22 < x < 42 else (240, 230, 200),
                "wrong": lambda x, y: (255, 0, 0) if 20 < x < 23 or 39 < x < 43 else (60, 60, 60)}
    for name, pixel in pictures.items():
        (folder / "pictures" / f"{name}.png").write_bytes(png(pixel))
    with open(folder / "results.jsonl", "w") as file:
        for row in rows():
            if row.get("check", {}).get("wrong", 0) > 0:
                row["pictures"] = {name: f"pictures/{name}.png" for name in pictures}
            file.write(json.dumps(row) + "\n")
    return folder / "results.jsonl"


if __name__ == "__main__":
    import pathlib
    import sys

    print(write(pathlib.Path(sys.argv[1])))
