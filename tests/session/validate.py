#!/usr/bin/env python3
# validate.py SCHEMA INSTANCE...: one line for every mistake, "INSTANCE: /place: what is wrong". Objects are closed:
# members that the schema does not name are mistakes, so that nothing is written that is not published.
import json
import pathlib
import sys

import jsonschema


def closed(schema):
    if isinstance(schema, list):
        return [closed(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: closed(value) for key, value in schema.items()}
    if isinstance(schema.get("properties"), dict):
        result["additionalProperties"] = False
    return result


schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(closed(schema))
for name in sys.argv[2:]:
    for error in validator.iter_errors(json.loads(pathlib.Path(name).read_text())):
        place = "".join(f"/{step}" for step in error.absolute_path)
        print(f"{name}: {place}: {error.message}")
