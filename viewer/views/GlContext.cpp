#include "viewer/views/GlContext.h"

#include <cassert>
#include <stdexcept>
#include <utility>

#include "rendering/gl/Context.h"

namespace fenestra::viewer {

GlContext::GlContext() {
  context_.setShareContext(QOpenGLContext::globalShareContext());
  context_.create();
  surface_.setFormat(context_.format());
  surface_.create();
}

GlContext::~GlContext() {
  done_ = {};
  stop();
}

bool GlContext::run(const std::function<void()>& work) {
  stop();
  QOpenGLContext* before = QOpenGLContext::currentContext();
  if (before == &context_) {
    work();
    return true;
  }
  QSurface* surface = before ? before->surface() : nullptr;
  if (!context_.makeCurrent(&surface_)) return false;
  // Also where `work` throws.
  struct Restore {
    QOpenGLContext &own, *before;
    QSurface* surface;
    ~Restore() {
      if (before)
        before->makeCurrent(surface);
      else
        own.doneCurrent();
    }
  } const restore{context_, before, surface};
  work();
  return true;
}

void GlContext::makeCurrentAndRun(const Work& work) {
  try {
    if (!context_.makeCurrent(&surface_)) throw std::runtime_error("OpenGL has lost its context; start Fenestra again");
    work(stop_);
    gl::finish();  // so that the widgets' contexts can use the new objects
  } catch (...) {
    error_ = std::current_exception();
  }
  context_.doneCurrent();
}

void GlContext::runBehind(Work work, Done done) {
  assert(!thread_ && QOpenGLContext::currentContext() != &context_);
  done_ = std::move(done);
  error_ = nullptr;
  stop_ = false;
  QThread* home = QThread::currentThread();
  if (!QOpenGLContext::supportsThreadedOpenGL()) {
    QOpenGLContext* before = QOpenGLContext::currentContext();
    QSurface* surface = before ? before->surface() : nullptr;
    makeCurrentAndRun(work);
    if (before) before->makeCurrent(surface);
    thread_.reset(QThread::create([] {}));
  } else {
    thread_.reset(QThread::create([this, home, work = std::move(work)] {
      makeCurrentAndRun(work);
      context_.moveToThread(home);
    }));
    context_.moveToThread(thread_.get());
  }
  connect(thread_.get(), &QThread::finished, this, [this, ended = thread_.get()] {
    if (thread_.get() == ended) finish();
  });
  thread_->start();
}

void GlContext::finish() {
  thread_->wait();
  thread_.release()->deleteLater();  // this may be called from its signal
  if (const Done done = std::exchange(done_, {})) done(std::exchange(error_, nullptr));
  Q_EMIT freed();
}

void GlContext::waitFor(int milliseconds) {
  if (thread_ && thread_->wait(static_cast<unsigned long>(milliseconds))) finish();
}

void GlContext::stop() {
  if (!thread_) return;
  stop_ = true;
  finish();
}

}  // namespace fenestra::viewer
