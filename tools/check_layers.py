#!/usr/bin/env python3
"""Fails when an #include or a clock crosses a layer it may not. Run by ctest as `layers`."""

import pathlib
import re
import sys

# Folder -> folders it may include besides itself. Read it as the architecture diagram.
MAY_INCLUDE = {
    "core": set(),
    "exchange": {"core"},
    "planner": {"core"},
    "supply": {"core"},
    "scheduler": {"core", "planner", "supply"},
    "agents": {"core", "planner"},
    "idl": set(),
    "transport": {"core", "idl"},
    "sim": {"core", "planner", "supply", "scheduler", "agents"},
    "mission": {"core", "exchange", "planner", "supply", "scheduler", "agents"},
    "process": {"core", "mission", "transport"},
    "app": {"core", "exchange", "planner", "supply", "scheduler", "agents", "mission", "transport", "sim"},
}
# Pattern -> the only folders, or files, where it may appear.
CONFINED = {
    r"#include <fast(dds|rtps|cdr)": {"transport"},
    r"#include <(ompl|geos|Eigen)": {"planner"},
    r"#include <yaml-cpp/": {"mission"},
    r"#include <(cpl|ogr|gdal|proj)[_.a-z]*\.h": {"exchange"},
    r"#include <nlohmann/": {"app", "exchange"},
    r"#include <spdlog/": {"transport", "app"},
    r"std::async|#include <future>": {"transport", "app", "planner/at_once.hpp"},
    r"steady_clock|system_clock|random_device|getenv|std::thread|std::mutex": {"transport", "app"},
}


def violations(root: pathlib.Path):
    for folder, allowed in MAY_INCLUDE.items():
        for file in sorted((root / folder).rglob("*.[ch]pp")):
            visible = allowed | {folder}
            if file.name == "main.cpp":  # only a process sees its scenario and the transport
                visible |= {"process", "mission"}
            for number, line in enumerate(file.read_text().splitlines(), start=1):
                where = f"{file.relative_to(root)}:{number}"
                include = re.match(r'#include "(\w+)/', line)
                if include and include[1] not in visible:
                    yield f"{where}: {folder} may not include {include[1]}"
                for pattern, homes in CONFINED.items():
                    at_home = folder in homes or str(file.relative_to(root)) in homes or (file.name == "main.cpp" and "app" in homes)
                    if not at_home and re.search(pattern, line):
                        yield f"{where}: `{pattern}` belongs in {', '.join(sorted(homes))}"


found = list(violations(pathlib.Path(sys.argv[1])))
print("\n".join(found))
sys.exit(bool(found))
