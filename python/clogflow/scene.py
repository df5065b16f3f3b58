"""The scene a file was made for: its text, and its values in SI units."""

import re
import tomllib

from .errors import FileError

QUANTITY = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?) (\S.*)", re.IGNORECASE)


class Scene:
    """An effective scene, as the program wrote it: every key with its value, quantities in SI units.

    `scene["particles.diameter"]` is the number in SI units, `scene.unit("particles.diameter")` its unit;
    words, switches and pure numbers are what they are. A section or a key that the scene has not raises KeyError.
    `scene.text` is a scene file that `clogflow.run` takes.
    """

    def __init__(self, scene_text: str, where: str = "scene") -> None:
        self.text = scene_text
        try:
            self.values: dict = tomllib.loads(scene_text)
        except tomllib.TOMLDecodeError as error:
            raise FileError(f"{where}: the scene in it is no TOML ({error})") from error

    def _entry(self, key: str) -> object:
        entry: object = self.values
        for part in key.split("."):
            if not isinstance(entry, dict) or part not in entry:
                raise KeyError(f"the scene has no {key}")
            entry = entry[part]
        return entry

    def __getitem__(self, key: str) -> object:
        return _si(self._entry(key))

    def __contains__(self, key: str) -> bool:
        try:
            self._entry(key)
        except KeyError:
            return False
        return True

    def unit(self, key: str) -> str:
        """SI unit of a key, "1" for what has none. Raises KeyError."""
        entry = self._entry(key)
        entry = entry[0] if isinstance(entry, list) and entry else entry
        found = QUANTITY.fullmatch(entry) if isinstance(entry, str) else None
        return found[2] if found else "1"

    def __repr__(self) -> str:
        return f"Scene({', '.join(self.values)})"


def _si(entry: object) -> object:
    if isinstance(entry, dict):
        return {key: _si(value) for key, value in entry.items()}
    if isinstance(entry, list):
        return [_si(value) for value in entry]
    found = QUANTITY.fullmatch(entry) if isinstance(entry, str) else None
    return float(found[1]) if found else entry
