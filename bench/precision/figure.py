def draw(result, image): pass
