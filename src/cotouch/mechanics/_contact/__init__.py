"""A step with tools: what they do to the skin, where body and tools go, and one balance of both."""
